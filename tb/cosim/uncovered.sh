#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# uncovered.sh PROGRAM --output LIST | --check LIST
# Runs coverage_verilog, PROGRAM, and lists how many of Verilator's coverage points it reaches, and the others as
# "instance signal". --check compares with a list; exit 1 if other points are missed. Versions of Verilator count
# differently, so the numbers do not matter.
set -euo pipefail
program=$1 action=$2 list=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
data=$folder/coverage.dat
"$program" "$data"

points=$(grep -ac '^C ' "$data")
missed=$(grep -ac '^C .* 0$' "$data") || true
{
  echo "$((points - missed)) of $points points reached"
  { grep -a '^C .* 0$' "$data" || true; } | tr '\001\002' ' =' | sed -E "s/.* o=([^ ]*) .*h=TOP\.([^ ]*)' 0/\2 \1/" | LC_ALL=C sort
} >"$folder/list"

case $action in
  --output) cp "$folder/list" "$list" ;;
  --check) diff <(tail -n +2 "$list") <(tail -n +2 "$folder/list") ;;
  *) exit 2 ;;
esac
