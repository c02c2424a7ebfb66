#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# without_tests_test.sh SOURCE: with BUILD_TESTING off the project needs no test library, builds its programs and nothing
# for tests, and has no tests. Without Verilator the programs lack engine verilator alone.
set -euo pipefail
source=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
if ! cmake -S "$source" -B "$folder/build" -G Ninja -DBUILD_TESTING=OFF -DCMAKE_DISABLE_FIND_PACKAGE_Catch2=ON \
  -DCMAKE_DISABLE_FIND_PACKAGE_rapidcheck=ON >"$folder/log" 2>&1; then
  cat "$folder/log" >&2
  exit 1
fi
# What the target all makes: programs, those that write the Verilog of engine verilator, and objects of no test.
ninja -C "$folder/build" -t commands all >"$folder/commands"
programs=$(sed -nE 's/.* -o (bin|tests)\/([^ ]+) .*/\1\/\2/p' "$folder/commands" | sort | paste -sd' ')
[ "$programs" = 'bin/blysk tests/exported tests/verilated_glue' ] || { echo "builds $programs" >&2 && exit 1; }
if grep -E 'Catch2|rapidcheck|_test\.cpp' "$folder/commands" >&2; then exit 1; fi
grep -q '^Total Tests: 0$' <<<"$(ctest --test-dir "$folder/build" -N)" || { echo 'there are tests' >&2 && exit 1; }

cmake -S "$source" -B "$folder/bare" -G Ninja -DBUILD_TESTING=OFF -DCMAKE_DISABLE_FIND_PACKAGE_Catch2=ON \
  -DCMAKE_DISABLE_FIND_PACKAGE_rapidcheck=ON -DCMAKE_DISABLE_FIND_PACKAGE_benchmark=ON \
  -DCMAKE_DISABLE_FIND_PACKAGE_verilator=ON >"$folder/log" 2>&1 || { cat "$folder/log" >&2 && exit 1; }
grep -q 'no engine verilator' "$folder/log" || { echo 'Verilator is used all the same' >&2 && exit 1; }
ninja -C "$folder/bare" -t commands all >"$folder/commands"
if grep -E 'verilated|Catch2|rapidcheck' "$folder/commands" | grep -v verilated_table >&2; then exit 1; fi

# Some formats: one object of netlists each, and none of the others'.
part() { cmake -S "$source" -B "$folder/part" -G Ninja -DBLYSK_FORMATS="$1" "${@:2}" >"$folder/log" 2>&1; }
part 'q10;q8' -DBUILD_TESTING=OFF -DBLYSK_VERILATED=OFF || { cat "$folder/log" >&2 && exit 1; }
ninja -C "$folder/part" -t commands all >"$folder/commands"
elaborated=$(sed -n 's/.* -DBLYSK_FORMAT=\(q[0-9]*\) .*/\1/p' "$folder/commands" | sort | paste -sd' ')
[ "$elaborated" = 'q10 q16 q8' ] || { echo "netlists of $elaborated, expected q10 q16 q8" >&2 && exit 1; }
if grep 'verilated' "$folder/commands" | grep -v verilated_table >&2; then exit 1; fi

# refused WHY FORMATS ARGUMENT...
refused() {
  if part "${@:2}"; then echo "configures with ${*:2}" >&2 && exit 1; fi
  grep -q "$1" "$folder/log" || { cat "$folder/log" >&2 && exit 1; }
}
refused 'BLYSK_FORMATS has q9, expected some of q8, q10' 'q8;q9' -DBUILD_TESTING=OFF
refused 'tests need all formats' q8 -DBUILD_TESTING=ON
refused 'tests need all formats' '' -DBUILD_TESTING=ON -DBLYSK_VERILATED=OFF
