#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# pipelined.sh VERILOG_FOLDER OTHER_FOLDER PROPERTY [FAULT]: proves a property of an exported pipelined device, with yosys.
# OTHER_FOLDER has the device without registers between its blocks.
#   wiring   with wires in the place of its pipes it is the other device, from the registers at the inputs to all outputs
#   stand    while the pipeline stands still, all registers keep what they hold
#   control  by induction: ready_o is !(stall_i && valid_o); a result that waits is still there after the next clock edge
# FAULT is a sed command that spoils the device's Verilog, to see that the proof fails then.
# Exit 0 if it is proved.
set -euo pipefail
self=$(readlink -f "${BASH_SOURCE[0]}")
usage() {
  sed -n '3,8s/^# //p' "$self" >&2
  exit 2
}
if [ ! -d "${1:-}" ] || [ ! -d "${2:-}" ]; then usage; fi
property=${3:-} fault=${4:-}
top=blysk_$(basename "$1")
other=blysk_$(basename "$2")
# Yosys takes a blank in a path for its end: copies in the current folder have none.
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/device" "$folder/other"
cp "$1"/*.v "$folder/device"
cp "$2"/*.v "$folder/other"
cp "$(dirname "$self")"/formal_control.v "$folder"
cd "$folder"
if [ -n "$fault" ]; then
  cat device/*.v >before
  sed -i "$fault" device/*.v
  if cat device/*.v | cmp -s - before; then
    echo "pipelined.sh: '$fault' changes nothing, expected a fault" >&2
    exit 2
  fi
fi
lower=
yosys -p 'help chformal' | grep -e ' -lower' >/dev/null && lower='chformal -lower'

case $property in
  wiring)
    # Both between the same registers; equal blocks on equal nets become one, so that nothing is left to be solved.
    for pipe in device/*_pipe_[!c]*.v; do
      sed -i -E 's/output reg/output wire/; /^  (reg|always)/,$d' "$pipe"
      printf '  assign q_o = d_i;\nendmodule\n' >>"$pipe"
    done
    # What a level sees of a net is another name of it then, under which its register would stay: cos_1, a_2, and so on.
    staged=$(printf 'w:*_%s ' {1..12})
    # combinational FOLDER TOP NAME: the module NAME with the registers as inputs.
    combinational() {
      echo "read_verilog $1/*.v; hierarchy -top $2; proc; flatten; memory -nordff; rename $2 $3
        rename -hide w:*.* $staged w:*_last w:*_first; opt_clean
        expose -input $(printf "$3/w:%s " n cos_delta r_ks g_ks b_ks); expose $3/w:brdf; delete $3/w:valid_o; opt_clean"
    }
    yosys -q -p "$(combinational device "$top" device)
      design -stash first
      $(combinational other "$other" other)
      design -copy-from first device
      delete -input */w:clk */w:rst_n */w:*_i; delete -output */w:ready_o
      opt_clean
      miter -equiv -flatten -make_assert device other miter
      hierarchy -top miter; opt -full; opt_merge; opt_clean
      sat -prove-asserts -verify miter"
    ;;
  stand)
    # Each register is enabled by the nets go or take, and take is never one without go.
    yosys -q -p "read_verilog device/*.v; hierarchy -top $top; proc; flatten; rename -hide w:*.*; opt_clean; opt_dff -keepdc; opt_clean
      select -set registers t:\$*ff t:\$*ffe
      select -assert-min 6 @registers
      select -set enabled w:go w:take %u %co:+[EN] t:\$sdffe %i
      select -assert-none @registers @enabled %d"
    ;;
  control)
    yosys -q -p "read_verilog device/*.v; hierarchy -top $top; proc; flatten; opt_clean; rename $top device; expose device/w:go device/w:take
      delete device/w:r_o device/w:g_o device/w:b_o; opt_clean
      read_verilog -formal formal_control.v; hierarchy -top formal_control
      proc; flatten; $lower; opt -full; techmap; opt -full
      sat -tempinduct -maxsteps 3 -prove-asserts -set-assumes -verify formal_control"
    ;;
  *) usage ;;
esac
