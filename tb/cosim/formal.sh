#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# formal.sh PROPERTY: proves a property of the exported q8 device with yosys' SAT solver.
#   range      by induction: the BRDF is at most 1, and no output exceeds its colour
#   hold       by induction: registers hold while no strobe writes them; outputs depend on nothing but registers
#   registers  by induction: the registers and output 29 are those of reference_quadratic.v
#   brdf       from registers 1 and 2 to the BRDF it is reference_quadratic.v, for every legal n and cosine
#   colours    multipliers 12..14 are those of reference_quadratic.v, for every BRDF and colour
# Exit 0 if it is proved.
set -euo pipefail
self=$(readlink -f "${BASH_SOURCE[0]}")
cd "$(dirname "$self")" # names without the folders above, which may have blanks that Yosys does not take
property=${1:-}

# Hiding the blocks' port nets leaves the device's own names for the registers.
device="
  read_verilog ../../rtl_verilog/quadratic_q8/*.v
  hierarchy -top blysk_quadratic_q8
  proc; flatten; opt -full; rename -hide w:*.*; opt_clean; rename blysk_quadratic_q8 device"
reference="
  read_verilog reference_quadratic.v
  rename reference_quadratic reference; proc reference; opt -full reference"
# Newer versions of yosys keep assertions as cells that have to be lowered for its solver.
lower=
yosys -p 'help chformal' | grep -e ' -lower' >/dev/null && lower='chformal -lower'
induct="proc; flatten; $lower; opt -full; techmap; opt -full
  sat -tempinduct -maxsteps 3 -prove-asserts -set-assumes -verify formal"

# nets MODULE NET...: "MODULE/w:NET ..."
nets() { printf "$1/w:%s " "${@:2}"; }

sequential() {
  yosys -q -p "$device; expose $(nets device n cos_delta r_ks g_ks b_ks brdf)
    $reference; expose $(nets reference n c red green blue brdf strobe17)
    read_verilog -formal -D PROVE_$1 formal.v
    hierarchy -check -top formal; $induct"
}

case $property in
  range) sequential RANGE ;;
  hold)
    # The combinational cone of 25..27 reaches the five registers and no input.
    yosys -q -p "$device
      select -set cone o:r_o o:g_o o:b_o %u %u %cie*
      select -assert-count 5 @cone $(nets device n cos_delta r_ks g_ks b_ks) %u %u %u %u %i
      select -assert-none @cone i:* %i"
    sequential HOLD
    ;;
  registers) sequential REGISTERS ;;
  brdf)
    # All cosines at once are too many for minisat (no answer in 100 s); 32 at a time, their upper bits fixed, are not.
    cases=$(for upper in {0..8}; do
      echo "sat -set cos_delta[8:5] $upper -set-assumes -prove-asserts -verify formal_brdf"
    done)
    yosys -q -p "$device; expose -input $(nets device n cos_delta); expose device/w:brdf
      $reference; expose -input $(nets reference n c); expose reference/w:brdf
      read_verilog -formal formal_brdf.v
      hierarchy -check -top formal_brdf
      proc; flatten; $lower; opt -full; wreduce; techmap; opt -full
      $cases"
    ;;
  colours)
    yosys -q -p "$device; $reference
      expose -input $(nets device brdf r_ks g_ks b_ks) $(nets reference brdf red green blue)
      read_verilog -formal formal_colours.v
      hierarchy -check -top formal_colours
      proc; flatten; $lower; wreduce; opt_merge; opt_clean; techmap; opt -full
      sat -prove-asserts -verify formal_colours"
    ;;
  *)
    sed -n '3,9s/^# //p' "$self" >&2
    exit 2
    ;;
esac
