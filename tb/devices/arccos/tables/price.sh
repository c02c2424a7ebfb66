#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# price.sh ROWS TABLE.csv: what the arc cosine costs, from the rows that scripts/synth has written below ROWS: quadratic, angle and
# arccos in q8. The cycles of a point by itself are those that unit.angle, unit.arccos and the strobes' tests hold.
set -euo pipefail
[ $# = 2 ] || { sed -n '3,4s/^# //p' "$0" >&2 && exit 2; }
rows=$1 table=$2

# value ROW PART KEY: a number of a part of the row.
value() {
  awk -v part="\"$2\": {" -v key="\"$3\":" '
    index($0, part) { inside = 1 }
    inside && $1 == key { sub(/,$/, "", $2); print $2; found = 1; exit }
    inside && /^  }/ { exit }
    END { exit !found }' "$1"
}

# median ROW: of the clocks that the seeds reach.
median() {
  awk '/"fmax_mhz": \[/ { inside = 1; next } inside && /\]/ { exit } inside { sub(/,/, ""); print $1 }' "$1" |
    sort -n | awk '{ of[NR] = $1 } END { if (NR == 0) exit 1; print of[int((NR + 1) / 2)] }'
}

text=device,format,cycles,lut,carry,ff,ram_bits,fmax_mhz,area_nand2,path_ns
for each in quadratic:2 angle:3 arccos:15; do
  device=${each%:*}
  row=$rows/$device/cost_q8.json
  [ -f "$row" ] || { echo "$row is not there, expected what scripts/synth $device q8 writes" >&2 && exit 2; }
  line=$device,q8,${each#*:}
  for key in lut carry ff ram_bits; do line+=,$(value "$row" ice40 $key); done
  line+=,$(median "$row")
  for key in area_nand2 path_ns; do line+=,$(value "$row" osu018 $key); done
  text+=$'\n'$line
done
printf '%s\n' "$text" >"$table"
