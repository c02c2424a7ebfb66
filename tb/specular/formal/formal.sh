#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# formal.sh VERILOG_FOLDER REFERENCE FORMAT PROPERTY [FAULT]: proves a property of an exported device that has the registers
# and colour multipliers of rtl_sysc/devices/specular.h, with yosys' SAT solver. REFERENCE is its reference.v.
#   range      by induction: the BRDF is at most 1; with `colours`, no output exceeds its colour
#   hold       by induction: registers hold while no strobe writes them; outputs depend on nothing but registers
#   registers  by induction: the registers and output 29 are those of the reference
#   brdf       from registers 1 and 2 to the BRDF it is the reference, for every n <= 1000 and legal cosine
#   colours    multipliers 12..14 are those of the reference, for every BRDF and colour
# FAULT is a sed command that spoils the reference or the property, to see that the proof fails then.
# Exit 0 if it is proved.
set -euo pipefail
self=$(readlink -f "${BASH_SOURCE[0]}")
if [ ! -d "${1:-}" ] || [ ! -f "${2:-}" ] || [[ ! ${3:-} =~ ^q[0-9]+$ ]]; then
  sed -n '3,11s/^# //p' "$self" >&2
  exit 2
fi
verilog=$1 format=$3 property=${4:-} fault=${5:-}
top=blysk_$(basename "$verilog")
fraction=${format#q}
# Yosys takes a blank in a path for its end: copies in the current folder have none.
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/device"
cp "$verilog"/*.v "$folder/device"
cp "$(dirname "$self")"/formal*.v "$folder"
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

# All other nets are hidden, so that no second name of a register, of wires behind it, stands in the place of its own.
device="
  read_verilog device/*.v
  hierarchy -top $top
  proc; flatten; memory -nordff; opt -full
  rename -hide w:* w:n w:cos_delta w:r_ks w:g_ks w:b_ks w:brdf %u %u %u %u %u %d
  opt_clean; rename $top device"
reference="
  read_verilog reference.v
  chparam -set F $fraction reference
  proc reference; memory -nordff reference; opt -full reference"
# Newer versions of yosys keep assertions as cells that have to be lowered for its solver.
lower=
yosys -p 'help chformal' | grep -e ' -lower' >/dev/null && lower='chformal -lower'

# properties TOP [OPTION]...: reads TOP.v, whose module is TOP, for the format.
properties() { echo "read_verilog -formal ${*:2} $1.v; chparam -set F $fraction $1; hierarchy -check -top $1"; }
# nets MODULE NET...: "MODULE/w:NET ..."
nets() { printf "$1/w:%s " "${@:2}"; }

# sequential PROPERTY [COMMANDS]: with further commands for the device.
sequential() {
  yosys -q -p "$device; ${2:-}; expose $(nets device n cos_delta r_ks g_ks b_ks brdf)
    $reference; expose $(nets reference n cos_delta r_ks g_ks b_ks brdf strobe17)
    $(properties formal -D PROVE_"$1")
    proc; flatten; $lower; opt -full; techmap; opt -full
    sat -tempinduct -maxsteps 3 -prove-asserts -set-assumes -verify formal"
}

case $property in
  range)
    # Where the last block limits the BRDF, it does so for any products.
    # shellcheck disable=SC2016 # a kind of cell
    sequential RANGE 'cutpoint device/t:$mul' >any_products 2>&1 || sequential RANGE
    ;;
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
    # All cosines at once are too many for minisat; 32 at a time, their upper bits fixed, are not.
    cases=$(for ((upper = 0; upper <= 1 << (fraction - 5); ++upper)); do
      echo "sat -set cos_delta[$fraction:5] $upper -set-assumes -prove-asserts -verify formal_brdf"
    done)
    yosys -q -p "$device; expose -input $(nets device n cos_delta); expose device/w:brdf
      $reference; expose -input $(nets reference n cos_delta); expose reference/w:brdf
      $(properties formal_brdf)
      proc; flatten; $lower; opt -full; wreduce; techmap; opt -full
      $cases"
    ;;
  colours)
    yosys -q -p "$device; $reference
      expose -input $(nets device brdf r_ks g_ks b_ks) $(nets reference brdf r_ks g_ks b_ks)
      $(properties formal_colours)
      proc; flatten; $lower; wreduce; opt_merge; opt_clean; techmap; opt -full
      sat -prove-asserts -verify formal_colours"
    ;;
  *)
    sed -n '3,11s/^# //p' "$self" >&2
    exit 2
    ;;
esac
