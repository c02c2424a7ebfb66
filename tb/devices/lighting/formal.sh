#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# formal.sh VERILOG_FOLDER REFERENCE FORMAT PROPERTY [FAULT]: proves a property of the exported unit by induction, with yosys'
# SAT solver, for all codes of its ports, legal or not.
#   equal  all outputs are those of REFERENCE, reference.v
#   range  no sum exceeds 255
#   stand  while a result waits, ready_o is zero and the sums stay
# FAULT is a sed command that spoils the reference or the property, to see that the proof fails then.
# Exit 0 if it is proved.
set -euo pipefail
self=$(readlink -f "${BASH_SOURCE[0]}")
if [ ! -d "${1:-}" ] || [ ! -f "${2:-}" ] || [[ ! ${3:-} =~ ^q[0-9]+$ ]] || [[ ! ${4:-} =~ ^(equal|range|stand)$ ]]; then
  sed -n '3,9s/^# //p' "$self" >&2
  exit 2
fi
verilog=$1 fraction=${3#q} property=${4^^} fault=${5:-}
top=blysk_$(basename "$verilog")
# Yosys takes a blank in a path for its end: copies in the current folder have none.
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/device"
cp "$verilog"/*.v "$folder/device"
cp "$(dirname "$self")/formal.v" "$folder"
cp "$2" "$folder/reference.v"
cd "$folder"
if [ -n "$fault" ]; then
  cat ./*.v >before
  sed -i "$fault" ./*.v
  if cat ./*.v | cmp -s - before; then
    echo "formal.sh: '$fault' changes nothing, expected a fault" >&2
    exit 2
  fi
fi
# Newer versions of yosys keep assertions as cells that have to be lowered for its solver.
lower=
yosys -p 'help chformal' | grep -e ' -lower' >/dev/null && lower='chformal -lower'
# Equal multipliers on equal nets become one, so that the solver has none.
yosys -q -p "
  read_verilog device/*.v; hierarchy -top $top; proc; flatten; opt -full; rename $top device
  read_verilog reference.v; chparam -set F $fraction reference; proc reference; opt -full reference
  read_verilog -formal -D PROVE_$property formal.v; chparam -set F $fraction formal; hierarchy -check -top formal
  proc; flatten; $lower; opt -full; wreduce; opt -full; techmap; opt -full
  sat -tempinduct -maxsteps 3 -prove-asserts -set-assumes -verify formal"
