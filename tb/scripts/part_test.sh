#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# part_test.sh SOURCE BLYSK FOLDER: a program with q8 and q16 alone, as scripts/run builds it, draws the picture that the whole one BLYSK
# draws, and refuses what it does not have. Built in FOLDER.
set -euo pipefail
source=$1 whole=$2 folder=$3
fail() { echo "$*" >&2 && exit 1; }
mkdir -p "$folder"
cmake -S "$source" -B "$folder" -G Ninja -DBUILD_TESTING=OFF -DBLYSK_FORMATS=q8 -DBLYSK_VERILATED=OFF -DCMAKE_UNITY_BUILD=ON >"$folder/log" 2>&1 &&
  cmake --build "$folder" --target blysk >>"$folder/log" 2>&1 || { tail -n 30 "$folder/log" >&2 && fail 'no build'; }
part=$folder/bin/blysk
for scene in sphere teapot; do
  asked=(render "$scene" --format q8 --engine systemc --watch highlight --size 40x30)
  "$part" "${asked[@]}" --output "$folder/part.png" --vcd "$folder/part.vcd" >/dev/null
  "$whole" "${asked[@]}" --output "$folder/whole.png" --vcd "$folder/whole.vcd" >/dev/null
  cmp "$folder/part.png" "$folder/whole.png"
  cmp <(grep -v '^blysk\|date\|20[0-9][0-9]' "$folder/part.vcd") <(grep -v '^blysk\|date\|20[0-9][0-9]' "$folder/whole.vcd")
done
"$part" list >"$folder/list"
"$whole" list >"$folder/of_whole"
diff "$folder/list" "$folder/of_whole"
# Rows that were measured are there; of those of other formats no latency is known.
asked=(explore --tolerance 0.01 --metric max_abs_err --domain lobe)
"$part" "${asked[@]}" >"$folder/answer" 2>"$folder/said"
"$whole" "${asked[@]}" >"$folder/of_whole"
diff "$folder/answer" "$folder/of_whole"
"$part" explore --csv >"$folder/rows" 2>"$folder/said"
[ "$(wc -l <"$folder/rows")" = "$("$whole" explore --csv | wc -l)" ] || fail 'explore has other rows'
"$part" explore >"$folder/rows" 2>"$folder/said"
grep -q 'rows are of formats that this build does not have' "$folder/said" || fail "explore says $(cat "$folder/said")"

# refused WHAT ARGUMENT...: status 2 and one line.
refused() {
  local status=0
  "$part" "${@:2}" >"$folder/said" 2>"$folder/error" || status=$?
  [ "$status" = 2 ] && [ "$(wc -l <"$folder/error")" = 1 ] && grep -qF "$1" "$folder/error" ||
    fail "${*:2}: status $status, $(cat "$folder/said" "$folder/error")"
}
points=$source/docs/examples/fig3.csv
for engine in bit systemc; do
  refused 'format q12 is not in this build' simulate --format q12 --engine $engine --stimulus "$points" --results -
done
refused 'format q12 is not in this build' export --format q12 --output "$folder/rtl"
refused 'format q10 is not in this build' render sphere --format q10 --output "$folder/none.png"
refused 'a build with Verilator' simulate --format q8 --engine verilator --stimulus "$points" --results -
[ ! -e "$folder/rtl" ] && [ ! -e "$folder/none.png" ] || fail 'something was written'
