#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# constraints.sh SCRIPTS SYNTHESIS EXPORTED CELLS DEVICE FORMAT: the exported device with the period of its .sdc is met in the
# cells, and one of nine tenths is not; so are the lines that it has as comments. Exit 77 where a tool or the cells are missing.
set -euo pipefail
unset CDPATH
scripts=$1 synthesis=$2 exported=$3 cells=$4 device=$5 format=$6
for tool in yosys sta; do
  command -v $tool >/dev/null || { echo "$tool is not there"; exit 77; }
done
[ -f "$cells" ] || { echo "$cells is not there: scripts/setup --synthesis fetches it"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/wrapper"
"$synthesis" prepare "$work" --device "$device" --format "$format"
"$exported" update "$work/rtl" "$device" "$format"
abc=$(sed -n "s/^abc_script='\(.*\)'$/\1/p" "$scripts/synth")
top=$(<"$work/top")
cd "$work"
cp "$cells" cells.lib
yosys -q -p "read_verilog $top*.v; synth -flatten -top $top; dfflibmap -liberty cells.lib
  abc -liberty cells.lib -script $abc; splitnets; opt_clean -purge; write_verilog -noattr -noexpr netlist.v"
cat >met.tcl <<'END'
read_liberty cells.lib
read_verilog netlist.v
link_design TOP
read_sdc SDC
puts "worst slack [worst_slack -max]"
END
# slack SDC: the worst of the setup checks, in ns.
slack() { sta -no_init -no_splash -exit <(sed "s/TOP/$top/; s,SDC,$1," met.tcl) | sed -n 's/^worst slack //p'; }
sed -E 's/^(set clk_period) (.*)$/\1 [expr {0.9 * \2}]/' "rtl/$top.sdc" >shorter.sdc
met=$(slack "rtl/$top.sdc")
missed=$(slack shorter.sdc)
echo "$(grep '^set clk_period' "rtl/$top.sdc"): worst slack $met ns; nine tenths of it: $missed ns"
awk -v met="$met" -v missed="$missed" 'BEGIN { exit !(met >= 0 && met < 0.1 && missed < 0) }'
# What a user takes the # away from holds at a faster clock, too.
grep -q '^# set_max_delay' "rtl/$top.sdc" || exit 0
faster() { sed -E 's/^set clk_period .*/set clk_period 5/' "rtl/$top.sdc"; }
faster >faster.sdc
faster | sed 's/^# set_max_delay/set_max_delay/' >max_delay.sdc
faster | sed -E 's/^# (set_max_delay) ([0-9.]+)/\1 [expr {0.5 * \2}]/' >half_delay.sdc
faster | sed 's/^# set strobe_gap/set strobe_gap/' >waiting.sdc
for sdc in faster max_delay half_delay waiting; do printf '%s %s\n' $sdc "$(slack $sdc.sdc)"; done >slacks
echo "clk_period 5, worst slack in ns: $(paste -sd ' ' slacks)"
awk '{ slack[$1] = $2 } END { exit !(slack["faster"] < 0 && slack["max_delay"] >= 0 && slack["half_delay"] < 0 && slack["waiting"] >= 0) }' slacks
