#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# settling.sh update|check BLYSK ROOT: docs/tables/settling.csv and the table of docs/delays.md are what `blysk settle` finds
# for each file of delays, or become it. The column `device` has the options too, as on a command line.
set -euo pipefail
unset CDPATH
mode=$1 blysk=$(readlink -f "$2") root=$(readlink -f "$3")
export LC_ALL=C
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
csv=$folder/settling.csv page=$root/docs/delays.md
echo 'device,format,smallest_gap_ns,path_ns,bound_ns,one_delay_a_block_ns,pairs,signal,bit,got,expected' >"$csv"
for file in "$root"/docs/tables/*/delays_q*.json; do
  device=$(sed -nE 's/^  "device": "(.*)",$/\1/p' "$file") format=$(sed -nE 's/^  "format": "(.*)",$/\1/p' "$file")
  options=$(sed -nE '/^  "options": \{$/,/^  \}/s/^    "(.*)": "(.*)",?$/ --\1 \2/p' "$file" | sed 's/ on$//' | tr -d '\n')
  # shellcheck disable=SC2086  # a word per option
  "$blysk" settle --device "$device" --format "$format" $options --delays "$file" --json >"$folder/found"
  value() { sed -nE "s/^ *\"$1\": \"?([A-Za-z0-9_.-]+)\"?,?$/\1/p" "$folder/found"; }
  printf '%s,%s' "$device$options" "$format" >>"$csv"
  for key in smallest_gap_ns path_ns bound_ns one_delay_a_block_ns pairs_tried signal bit got expected; do
    printf ',%s' "$(value $key)" >>"$csv"
  done
  echo >>"$csv"
done
# In the order of the formats' numbers.
{ sed -n 1p "$csv" && tail -n +2 "$csv" | sort -t , -k 1,1 -k 2.2,2n; } >"$folder/sorted"
mv "$folder/sorted" "$csv"
{
  echo '| device | format | smallest gap, ns | path | bound by bits | one delay a block | one step below |'
  echo '|---|---|---:|---:|---:|---:|---|'
  tail -n +2 "$csv" | awk -F , '{ printf "| %s | %s | %s | %s | %s | %s | %s bit %s: code %s for %s |\n", $1, $2, $3, $4, $5, $6, $8, $9, $10, $11 }'
} >"$folder/table"
awk -v table="$folder/table" '
  /^<!-- generated: settling -->$/ { print; while ((getline line < table) > 0) print line; inside = 1; found = 1; next }
  /^<!-- end of generated -->$/ { inside = 0 }
  !inside { print }
  END { exit !found }' "$page" >"$folder/page" || { echo "$page has no place for the table"; exit 1; }
if [ "$mode" = check ]; then
  diff "$root/docs/tables/settling.csv" "$csv"
  diff "$page" "$folder/page"
else
  cp "$csv" "$root/docs/tables/settling.csv"
  cp "$folder/page" "$page"
fi
