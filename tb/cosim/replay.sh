#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# replay.sh REPLAY_VECTORS VERILOG_FOLDER DEVICE FORMAT [stuck]: Icarus replays BLYSK_REPLAYED (3000) random writes on the
# exported device.
# Exit 0 if all was compared and nothing differs. With `stuck` the bench has to notice each output that is held at 0, by a
# difference or as there is nothing to compare.
set -euo pipefail
[ $# = 4 ] || [ "$#${5:-}" = 5stuck ] || { sed -n '3,6s/^# //p' "$0" >&2 && exit 2; }
vectors=$1 verilog=$(readlink -f "$2") device=$3 format=$4 stuck=${5:-} count=${BLYSK_REPLAYED:-3000}
bench=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/replay
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$vectors" "$device" "$format" "$count" --output "$folder"
grep -q TRAILING_BITS "$folder/device.vh" || bench+=_handshake
cp "$verilog"/*.v "$bench.v" "$folder"
cd "$folder"
iverilog -g2001 -s replay -o replay.vvp ./*.v

# replayed [PORT]: the bench's last line, PORT held at 0.
replayed() {
  vvp -n replay.vvp ${1:+"+stuck_$1"} >said
  tail -n 1 said
}

if [ -z "$stuck" ]; then
  said=$(replayed)
  echo "$said"
  results=$count
  [ ! -e results.txt ] || results=$(wc -l <results.txt)
  [ "$said" = "$count writes replayed, $results compared, 0 differ" ]
  exit
fi
ports=$(grep -o 'stuck_[A-Za-z0-9_]*' device.vh | sed 's/^stuck_//')
for port in ${ports:?no output in device.vh}; do
  said=$(replayed "$port")
  echo "$port: $said"
  if [ -e results.txt ]; then
    [[ $said =~ ,\ [1-9][0-9]*\ differ$ ]]
  else
    [[ $said =~ ^$count\ writes\ replayed,\ ($count\ compared,\ [1-9][0-9]*|0\ compared,\ 0)\ differ$ ]]
  fi
done
