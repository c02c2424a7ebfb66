#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# four_state.sh REPLAY_VECTORS VERILOG_FOLDER DEVICE FORMAT: no X leaves the exported device after its reset, in Icarus, with
# 500 random writes, or BLYSK_REPLAYED rows of a device with start and ready, and X on the data inputs between them. Without the
# reset the bench has to see X.
set -euo pipefail
[ $# = 4 ] || { sed -n '3,5s/^# //p' "$0" >&2 && exit 2; }
vectors=$1 verilog=$(readlink -f "$2") device=$3 format=$4 count=500
bench=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/four_state
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$vectors" "$device" "$format" "${BLYSK_REPLAYED:-$count}" --output "$folder"
kind=writes
if ! grep -q TRAILING_BITS "$folder/device.vh"; then
  bench+=_handshake
  count=${BLYSK_REPLAYED:-$count}
  kind="rows, $(wc -l <"$folder/results.txt") delivered"
fi
cp "$verilog"/*.v "$bench.v" "$folder"
cd "$folder"
iverilog -g2001 -s four_state -o four_state.vvp ./*.v
vvp -n four_state.vvp | tee said
[[ $(tail -n 1 said) =~ ^$count\ $kind,\ outputs\ looked\ at\ [1-9][0-9]{3,}\ times,\ X\ 0\ times$ ]]
said=$(vvp -n four_state.vvp +no_reset | tail -n 1)
echo "without reset: $said"
[[ $said =~ ,\ X\ [1-9][0-9]*\ times$ ]]
