#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# clang_test.sh SOURCE FOLDER: clang builds blysk, without what Verilator generates, and warns of nothing; the program computes
# fig. 3's writes. The sources of tests are read by clang in lint.tidy.
set -euo pipefail
command -v clang++ >/dev/null || { echo 'clang++ is not installed' >&2 && exit 77; }
source=$1 folder=$2
mkdir -p "$folder"
quietly() { "$@" >"$folder/log" 2>&1 </dev/null || { tail -n 40 "$folder/log" >&2 && exit 1; }; }
quietly cmake -S "$source" --preset clang -B "$folder" -DBUILD_TESTING=OFF -DCMAKE_DISABLE_FIND_PACKAGE_verilator=ON
quietly cmake --build "$folder" --target blysk
for engine in bit systemc; do
  "$folder/bin/blysk" simulate --engine "$engine" --stimulus "$source/docs/examples/fig3.csv" --results "$folder/$engine.csv"
done
cmp "$folder/bit.csv" "$folder/systemc.csv"
