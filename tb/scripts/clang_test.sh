#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# clang_test.sh SOURCE FOLDER: clang builds programs and tests, without what Verilator generates, and warns of nothing; the
# quick tests of units pass.
set -euo pipefail
command -v clang++ >/dev/null || { echo 'clang++ is not installed' >&2 && exit 77; }
mkdir -p "$2"
quietly() { "$@" >"$folder/log" 2>&1 </dev/null || { tail -n 40 "$folder/log" >&2 && exit 1; }; }
folder=$2
quietly cmake -S "$1" --preset clang -B "$folder" -DCMAKE_DISABLE_FIND_PACKAGE_verilator=ON
quietly cmake --build "$folder"
exec ctest --test-dir "$folder" -j 2 --output-on-failure --no-tests=error -L '^quick$' -R '^(unit|blocks|core|netlist|golden)\.' \
  -E must_not_compile
