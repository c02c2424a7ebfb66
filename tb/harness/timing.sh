#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# timing.sh check|update BLYSK DRAW_WAVES ROOT: docs/figures/fig3.json and .svg are the timing diagram of README's run of
# docs/examples/fig3.csv through SystemC, or are made so. Exit 1 if they are others.
set -euo pipefail
action=$1 blysk=$(readlink -f "$2") draw_waves=$(readlink -f "$3") root=$(readlink -f "$4")
figure=$root/docs/figures/fig3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$blysk" simulate --engine systemc --stimulus "$root/docs/examples/fig3.csv" --results "$work/fig3.csv" --vcd "$work/fig3.vcd" >"$work/log"
draw=("$draw_waves" "$work/fig3.vcd" --json "$figure.json" --svg "$figure.svg" --first 3 --count 24)
if [ "$action" = update ]; then
  "${draw[@]}"
  exit
fi
"${draw[@]}" --check
# One changed bit in the waves is another picture: 17 up a clock later.
sed '0,/^1aaaaf$/s//0aaaaf/' "$work/fig3.vcd" >"$work/changed.vcd"
if cmp -s "$work/fig3.vcd" "$work/changed.vcd"; then echo 'nothing is changed' >&2 && exit 1; fi
status=0
"$draw_waves" "$work/changed.vcd" "${draw[@]:2}" --check >"$work/log" || status=$?
if [ "$status" != 1 ] || ! grep -q 'is stale' "$work/log"; then echo "a changed wave is not noticed: $status" >&2 && exit 1; fi
