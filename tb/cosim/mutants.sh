#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# mutants.sh list FOLDER VERILOG_FOLDER COUNT: chooses COUNT single faults of the exported device. FOLDER/list.ys has them,
#   device.il the flat device, control.txt the cells that registers' enables and resets come from.
# mutants.sh module FOLDER FIRST LAST: of those the mutants FIRST..LAST as one module, FOLDER/mutants_LAST.v, with the
#   input `mutant` that selects one.
set -euo pipefail
usage() { sed -n '3,6s/^# //p' "$0" >&2 && exit 2; }
[ $# = 4 ] || usage
action=$1 folder=$2
mkdir -p "$folder"
case $action in
  list)
    verilog=$(readlink -f "$3") count=$4
    cd "$folder"
    ln -sfn "$verilog" rtl # yosys takes a blank in a path for its end
    yosys -q -p "
      read_verilog rtl/*.v
      hierarchy -top blysk_$(basename "$verilog")
      proc; flatten; memory -nordff; opt -full; clean
      select -set registers t:\$dff t:\$dffe t:\$sdff t:\$sdffe t:\$sdffce %u %u %u %u
      select -write control.txt @registers %ci:+[EN]:+[SRST] @registers %d %cie* t:* %i
      mutate -list $count -seed 1 -ctrl mutant 16 1 -o list.ys
      rename -top mutants
      write_rtlil device.il"
    ;;
  module)
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
  *) usage ;;
esac
