#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# mutants.sh list FOLDER VERILOG_FOLDER COUNT: chooses COUNT single faults of the exported device. FOLDER/list.ys has them,
#   device.il the flat device, control.txt the cells that registers' enables and resets come from, protocol.txt those that
#   valid_o and ready_o depend on.
# mutants.sh module FOLDER FIRST LAST: of those the mutants FIRST..LAST as one module, FOLDER/mutants_LAST.v, with the
#   input `mutant` that selects one.
# mutants.sh prove FOLDER NUMBER [STATES FRACTION [STEPS]]: exit 0 if that mutant is proved to be the device: from every state
#   both go to the same state and give the same outputs, whatever the inputs are. With STATES, a device's states.v, from every
#   state that it allows; that the device keeps to it is proved by states.sh. FRACTION is the F of the format. With STEPS also
#   if both give the same outputs in all cycles from a reset on, by induction over so many cycles.
set -euo pipefail
self=$(readlink -f "${BASH_SOURCE[0]}")
usage() { sed -n '3,11s/^# //p' "$self" >&2 && exit 2; }
if [ $# -lt 3 ]; then usage; fi
action=$1 folder=$2
mkdir -p "$folder"
case $action in
  list)
    [ $# = 4 ] || usage
    verilog=$(readlink -f "$3") count=$4
    cd "$folder"
    ln -sfn "$verilog" rtl # yosys takes a blank in a path for its end
    yosys -q -p "
      read_verilog rtl/*.v
      hierarchy -top blysk_$(basename "$verilog")
      proc; flatten; memory -nordff; opt -full; clean
      select -set registers t:\$dff t:\$dffe t:\$sdff t:\$sdffe t:\$sdffce %u %u %u %u
      select -write protocol.txt o:valid_o o:ready_o %u %ci* t:* %i
      select -write control.txt @registers %ci:+[EN]:+[SRST] @registers %d %cie* t:* %i
      mutate -list $count -seed 1 -ctrl mutant 16 1 -o list.ys
      rename -top mutants
      write_rtlil device.il"
    ;;
  module)
    [ $# = 4 ] || usage
    first=$3 last=$4
    cd "$folder"
    # The list names the module as the device has it.
    sed -n "${first},${last}s/-module [^ ]*/-module mutants/p" list.ys >"mutants_$last.ys"
    yosys -q -p "
      read_rtlil device.il
      script mutants_$last.ys
      splitnets
      write_verilog -noattr mutants_$last.v"
    ;;
  prove)
    [ $# = 3 ] || [ $# = 5 ] || [ $# = 6 ] || usage
    number=$3 states=${4:+$(readlink -f "$4")} fraction=${5:-} steps=${6:-}
    own=$(mktemp -d)
    trap 'rm -rf "$own"' EXIT
    cp "$folder/device.il" "$own"
    fault=$(sed -n "${number}p" "$folder/list.ys" | sed -E 's/-ctrl [^ ]+ [0-9]+ [0-9]+//; s/-module [^ ]+/-module gate/')
    [ -n "$fault" ] || { echo "mutants.sh: $folder/list.ys has no mutant $number" >&2 && exit 2; }
    cd "$own"
    allowed=
    if [ -n "$states" ]; then
      cp "$states" states.v
      allowed="read_verilog -formal states.v; chparam -set F $fraction states; proc states; chformal -assert2assume states"
    fi
    yosys -q -p "read_rtlil device.il; copy mutants gate; $fault; dffunmap; write_rtlil both.il"
    # watched CUT: both with the states; with CUT=1 what a register holds is an input, and what it takes an output.
    watched() { awk -v module=mutants -v cut="$1" -f "$(dirname "$self")/states.awk" ${states:+states.v} both.il; }
    miter="$allowed; miter -equiv -flatten mutants gate miter; hierarchy -top miter; flatten; opt -full; opt_merge; opt_clean"
    watched 1 >cut.il
    yosys -q -p "
      read_rtlil cut.il
      select -assert-none t:\$*ff*
      $miter
      sat -set-assumes -prove trigger 0 -verify miter" && exit 0
    # Over time yosys takes all clocks for one.
    [ -n "$steps" ] && [[ $fault != *"-port CLK "* ]] || exit 1
    watched 0 >whole.il
    yosys -q -p "
      read_rtlil whole.il
      $miter; dffunmap; opt_clean
      sat -set-assumes -seq $((steps + 1)) -set-at 1 in_rst_n 0 -prove trigger 0 -prove-skip 1 -verify miter
      sat -set-assumes -tempinduct -tempinduct-inductonly -maxsteps $steps -prove trigger 0 -verify miter"
    ;;
  *) usage ;;
esac
