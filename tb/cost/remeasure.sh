#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# remeasure.sh SYNTHESIS TABLES DEVICE FORMAT [--OPTION VALUE]...: the row's cells of an iCE40, measured again, are what the
# row says. Exit 77 where Yosys is missing or of another version than the row's: cells differ between versions.
set -euo pipefail
unset CDPATH
synthesis=$1
chosen=(--device "$3" --format "$4" "${@:5}")
row=$2/$("$synthesis" path "${chosen[@]}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
[ -f "$row" ] || { echo "$row is missing: scripts/synth $3 $4 ${*:5} measures it"; exit 1; }
command -v yosys >/dev/null || { echo "yosys is not there"; exit 77; }
version=$(yosys --version | sed -n 1p)
grep -qF "\"yosys\": \"$version\"" "$row" || { echo "$row was measured by another Yosys than $version"; exit 77; }
mkdir -p "$work/wrapper" "$work/ice40"
"$synthesis" prepare "$work" "${chosen[@]}"
grep -qF "\"digest\": \"$(<"$work/digest")\"" "$row" ||
  { echo "$row is stale: it belongs to another Verilog; scripts/synth $3 $4 ${*:5} measures it"; exit 1; }
# The script of the row itself, so that it says what it did.
script=$(awk '/"ice40": \{/ { found = 1 } found && /"script":/ { sub(/^ *"script": "/, ""); sub(/",?$/, ""); print; exit }' "$row")
yosys -q -p "read_verilog $work/*.v; $script; tee -q -o $work/ice40/stat.json stat -json" >"$work/log" 2>&1 ||
  { cat "$work/log"; exit 1; }
echo "$script" >"$work/ice40/script"
echo "yosys $version" >"$work/ice40/tools"
touch "$work/ice40/done"
cp "$row" "$work/row.json"
"$synthesis" collect "$work" "${chosen[@]}" --row "$work/row.json"
diff "$row" "$work/row.json"
