#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# states.sh VERILOG_FOLDER STATES FORMAT [FAULT]: proves by induction, with yosys' SAT solver, that the exported device keeps to
# STATES, its states.v, from its first reset on, whatever its inputs are. FAULT is a sed command that spoils the device's
# Verilog or STATES, to see that the proof fails then. Exit 0 if it is proved.
set -euo pipefail
self=$(readlink -f "${BASH_SOURCE[0]}")
if [ ! -d "${1:-}" ] || [ ! -f "${2:-}" ] || [[ ! ${3:-} =~ ^q[0-9]+$ ]]; then
  sed -n '3,5s/^# //p' "$self" >&2
  exit 2
fi
verilog=$1 fraction=${3#q} fault=${4:-}
# Yosys takes a blank in a path for its end: copies in the current folder have none.
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/device"
cp "$verilog"/*.v "$folder/device"
cp "$2" "$folder/states.v"
cd "$folder"
if [ -n "$fault" ]; then
  cat device/*.v states.v >before
  sed -i "$fault" device/*.v states.v
  if cat device/*.v states.v | cmp -s - before; then
    echo "states.sh: '$fault' changes nothing, expected a fault" >&2
    exit 2
  fi
fi
# Newer versions of yosys keep assertions as cells that have to be lowered for its solver.
lower=
yosys -p 'help chformal' | grep -e ' -lower' >/dev/null && lower='chformal -lower'
yosys -q -p "
  read_verilog device/*.v
  hierarchy -top blysk_$(basename "$verilog")
  proc; flatten; memory -nordff; opt -full; rename -top device
  write_rtlil device.il"
awk -v module=device -f "$(dirname "$self")/states.awk" states.v device.il >watched.il
# Two edges after the one that sees the reset, then from two to the next one.
yosys -q -p "
  read_rtlil watched.il
  read_verilog -formal -D OVER_TIME states.v
  chparam -set F $fraction states
  hierarchy -top device; proc; flatten; $lower; opt -full; dffunmap; opt_clean
  sat -seq 3 -set-at 1 rst_n 0 -prove-asserts -prove-skip 1 -verify device
  sat -tempinduct -tempinduct-inductonly -maxsteps 2 -prove-asserts -verify device"
