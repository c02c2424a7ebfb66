#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# synth_test.sh ROOT SYNTHESIS: scripts/synth with stand-ins for the tools: what it writes, and what it does where one is
# missing, fails, takes too long or says nothing that can be read.
set -euo pipefail
unset CDPATH
root=$(readlink -f "$1")
BLYSK_SYNTHESIS=$(readlink -f "$2")
export BLYSK_SYNTHESIS LC_ALL=C BLYSK_TOOL_SECONDS=20
device=$(sed -nE 's/^BLYSK_DEVICE\(.*"(.+)".*/\1/p' "$root/tb/devices/devices.def" | sed -n 1p)
identifier=${device//-/_}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
tree=$folder/"a tree"
mkdir -p "$tree/tb/devices" "$tree/build/deps/osu018" "$folder/tools" "$folder/rows"
cp -R "$root/scripts" "$tree"
cp "$root/tb/formats.def" "$tree/tb"
cp "$root/tb/devices/devices.def" "$tree/tb/devices"
printf 'cell (NAND2X1) {\narea : 24;\n' >"$tree/build/deps/osu018/osu018_stdcells.lib"
export BLYSK_ROWS=$folder/rows
row=$folder/rows/$identifier/cost_q8.json

# Everything else of the machine, so that a tool can be missing.
ln -s /usr/bin/* "$folder/tools"
rm -f "$folder"/tools/{yosys,nextpnr-ice40,sta}
# shellcheck disable=SC2123  # it is
PATH=$folder/tools

# stub NAME: a tool whose script is standard input.
# shellcheck disable=SC2016  # the stand-ins' own variables stand in quotes
stub() { { echo '#!/bin/bash' && cat; } >"$folder/tools/$1.new" && chmod +x "$folder/tools/$1.new" && mv "$folder/tools/$1.new" "$folder/tools/$1"; }
# shellcheck disable=SC2016  # the stand-ins' own variables
{
  good_yosys='
[ "$1" = --version ] && { echo "Yosys 1"; exit; }
stat=$(sed -n "s/.*tee -q -o \(.*\) stat .*/\1/p" <<<"$2")
case $stat in
  *.json) echo "{\"design\": {\"num_cells_by_type\": {\"SB_LUT4\": ${LUT:-7}}}}" >"$stat" ;;
  *.txt) printf "Number of cells: 3\nChip area for module x: 240.0\n" >"$stat" ;;
esac'
  good_nextpnr='
[ "$1" = --version ] && { echo "nextpnr 1" >&2; exit; }
while [ "$1" != --seed ]; do shift; done
echo "{\"fmax\": {\"clk\": {\"achieved\": $((20 + $2))}}}" >"$4"'
  good_sta='
[ "$1" = -version ] && { echo 2; exit; }
echo "   990.0  slack (MET)"'
}
fail() { echo "$*" >&2 && exit 1; }
# runs STATUS LINE: the script ends so, and says the line (a regular expression) once.
runs() {
  local status=0
  "$tree/scripts/synth" "$device" q8 >"$folder/said" 2>"$folder/error" || status=$?
  cat "$folder/error"
  [ "$status" = "$1" ] || fail "status $status, expected $1"
  [ -z "$2" ] || [ "$(grep -cE -- "$2" "$folder/error")" = 1 ] || fail "expected one line: $2"
}
has() { grep -qF -- "$1" "$row" || fail "the row lacks $1: $(cat "$row")"; }

stub yosys <<<"$good_yosys"
stub sta <<<"$good_sta"

# The first row, without one of the tools.
runs 1 'hx8k skipped, nextpnr-ice40 is not there .*; the row goes without$'
has '"lut": 7'
has '"area_nand2": 10.0'
has '"path_ns": 10.0'
! grep -q hx8k "$row" || fail "hx8k without nextpnr"

# Everything is there.
stub nextpnr-ice40 <<<"$good_nextpnr"
runs 0 ''
[ "$(wc -l <"$folder/error")" = 1 ] || fail "more than its progress"
[[ $(tr -d ' \n' <"$row") == *'"fmax_mhz":[21.0,22.0,23.0,24.0,25.0]'* ]] || fail "no clocks"
has '"yosys": "Yosys 1"'
cp "$row" "$folder/good"

# A tool that fails, is gone, or does not end: its part stays as it was, the others are measured.
stub nextpnr-ice40 <<<'exit 1'
LUT=8 runs 1 "hx8k skipped, nextpnr-ice40 (failed|is not there).*; .*cost_q8.json keeps what was measured before"
has '"lut": 8'
has '"path_ns": 10.0'
grep -q '"part": "hx8k' "$row" || fail "hx8k is lost"
stub nextpnr-ice40 <<<"$good_nextpnr"
# shellcheck disable=SC2016
stub sta <<<'[ "$1" = -version ] && { echo 2; exit; }
while :; do :; done'
BLYSK_TOOL_SECONDS=1 runs 1 'osu018 skipped, sta failed or took more than 1 s'
has '"path_ns": 10.0'

# What a tool says cannot be read: nothing is written.
# shellcheck disable=SC2016
stub sta <<<'[ "$1" = -version ] && { echo 2; exit; }
echo "Error: syntax"; echo " 1.0 slack (MET)"'
cp "$row" "$folder/before"
runs 2 'reports an error of OpenSTA'
cmp "$row" "$folder/before" || fail "the row was written"

stub sta <<<"$good_sta"

# The device written by hand has a row of its own, of its own Verilog.
mkdir -p "$tree/tb/devices/$identifier"
cp "$root/tb/devices/$identifier/reference.v" "$tree/tb/devices/$identifier"
"$tree/scripts/synth" "$device" q8 --reference 2>"$folder/error" || fail "$(cat "$folder/error")"
cmp "$row" "$folder/before" || fail "the row of the export was written"
by_hand=$folder/rows/$identifier/reference_q8.json
grep -qF '"lut": 7' "$by_hand" || fail "no row of the device written by hand"
[ "$(grep -o '"digest": "[^"]*"' "$by_hand" | sort -u | wc -l)" = 1 ] || fail "digests differ"
[ "$(grep -o -m 1 '"digest": "[^"]*"' "$by_hand")" != "$(grep -o -m 1 '"digest": "[^"]*"' "$row")" ] || fail "the export was measured"

# Delays without a tool: nothing is written.
rm "$folder/tools/sta"
status=0
"$tree/scripts/synth" --delays "$device" q8 2>"$folder/error" || status=$?
cat "$folder/error"
if [ "$status" != 1 ] || ! grep -q 'delays skipped, sta is not there .*; nothing is written$' "$folder/error"; then
  fail "delays without sta: status $status"
fi
[ ! -e "$folder/rows/$identifier/delays_q8.json" ] || fail "delays without sta were written"

# Bad use.
stub sta <<<"$good_sta"
for words in --delays "--delays --nothing" "$device q9" "nothing q8" "$device q8 --nothing" "$device q8 -x" "--reference"; do
  status=0
  # shellcheck disable=SC2086  # a word each
  "$tree/scripts/synth" $words 2>"$folder/error" || status=$?
  if [ "$status" = 2 ] && [ "$(grep -c '^blysk' "$folder/error")" = 1 ]; then continue; fi
  fail "$words: status $status, $(cat "$folder/error")"
done
[ "$(ls "$folder/rows")" = "$identifier" ] || fail "rows of bad use"
