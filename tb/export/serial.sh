#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# serial.sh BLYSK DEVICE FORMAT simulated|mapped|refused: the serial wrapper of a device.
#   simulated  vectors go through the line in Icarus, `blysk check` finds the answers equal, and those of a wrapper with a
#              fault different; what is no vector comes back with a question mark
#   mapped     for the HX8K board: yosys, nextpnr-ice40 and icepack make a bitstream, a clock of 12 MHz is reached, and the
#              mapped netlist answers as the device does
#   refused    the device has no strobes
set -euo pipefail
blysk=$(readlink -f "$1")
bench=$(dirname "$(readlink -f "$0")")/serial_bench.v
device=$2 format=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
fail() { echo "$*" >&2 && exit 1; }

export=("$blysk" export --device "$device" --format "$format" --wrapper serial --output rtl)
if [ "$4" = refused ]; then
  status=0
  "${export[@]}" >said 2>error || status=$?
  if [ "$status" != 2 ] || [ "$(wc -l <error)" != 1 ] || ! grep -q 'a device with strobes' error || [ -e rtl ]; then
    fail "expected a refusal in one line: status $status, $(cat error)"
  fi
  exit
fi
"${export[@]}" >log
serials=(rtl/*_serial.v)
top=$(basename "${serials[0]}" .v)
[ -e "rtl/$top.pcf" ] || fail 'no pins'

# judge BENCH VECTORS: the verdict on what comes back, as exit status.
judge() {
  vvp -n "$1" +vectors="$2" +answers=answers >log || { cat log >&2 && exit 1; }
  sed '1s/.*/# some vectors/' answers >some
  local status=0
  "$blysk" check --device "$device" --format "$format" --answers some >verdict 2>&1 || status=$?
  echo "$status"
}
# some EVERY: the first line of the vectors, and each EVERY-th of the others.
some() { sed -n -e 1p -e "2~$1p" all; }
"$blysk" vectors --device "$device" --format "$format" --output all

if [ "$4" = mapped ]; then
  for tool in yosys nextpnr-ice40 icepack; do
    command -v "$tool" >/dev/null || { echo "$tool is not there, scripts/setup --synthesis installs it" && exit 77; }
  done
  yosys -q -p "read_verilog rtl/*.v; synth_ice40 -top $top -json mapped.json; write_verilog -noattr mapped.v"
  nextpnr-ice40 --hx8k --package ct256 --freq 12 --seed 1 --json mapped.json --pcf "rtl/$top.pcf" --asc mapped.asc >log 2>&1 ||
    { cat log >&2 && fail 'it does not fit, or is too slow'; }
  grep 'ICESTORM_LC:' log
  grep 'Max frequency' log | tail -n 1
  icepack mapped.asc mapped.bin
  [ "$(stat -c %s mapped.bin)" -gt 100000 ] || fail 'no bitstream'
  cells=$(dirname "$(readlink -f "$(command -v yosys)")")/../share/yosys/ice40/cells_sim.v
  iverilog -g2005 -DMAPPED -DNO_ICE40_DEFAULT_ASSIGNMENTS "-DDUT=$top" -s serial_bench -o bench "$bench" mapped.v "$cells"
  some 2503 >vectors
  [ "$(judge bench vectors)" = 0 ] || { cat verdict >&2 && fail 'the netlist answers otherwise'; }
  exit
fi

verilator --lint-only -Wall --top-module "$top" rtl/*.v
iverilog -g2001 "-DDUT=$top" -s serial_bench -o bench "$bench" rtl/*.v
some 601 >vectors
[ "$(judge bench vectors)" = 0 ] || { cat verdict >&2 && fail 'the answers differ'; }
[ "$(sed 1d answers | wc -l)" = "$(sed 1d vectors | wc -l)" ] || fail 'answers are missing'
[ "$(sed -n 1p answers)" = "$(sed -n 1p vectors)" ] || fail 'the first line does not come back'

# What is no vector: a letter, a digit less, one more. Capitals and the ends of lines of other systems are read.
vector=$(sed -n 2p vectors) answer=$(sed -n 2p answers)
printf '%s\n' "x $vector" "${vector%?}" "${vector}0" >odd
printf '%s\r\n' "$(tr a-f A-F <<<"$vector")" >>odd
vvp -n bench +vectors=odd +answers=back >log
printf '%s ?\n' "x $vector" "${vector%?}" "${vector}0" >expected
tr a-f A-F <<<"$vector" | tr -d '\n' >>expected
printf '%s\n' "${answer#"$vector"}" >>expected
diff back expected || fail 'what is no vector'

# A strobe that never comes, a register that shifts in the wrong order: the verdict is "different".
for fault in "s/(state == PUT)/(1'b0)/" 's/answer <= {answer\[/answer <= {~answer[/'; do
  rm -rf spoilt && cp -r rtl spoilt
  sed -i "$fault" "spoilt/$top.v"
  ! cmp -s "spoilt/$top.v" "rtl/$top.v" || fail "nothing is spoilt by $fault"
  iverilog -g2001 "-DDUT=$top" -s serial_bench -o spoilt.bench "$bench" spoilt/*.v
  [ "$(judge spoilt.bench vectors)" = 1 ] || fail "not noticed: $fault"
done
