#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# sdf_test.sh ROOT SYNTHESIS BLYSK DEVICE FORMAT: scripts/synth --sdf writes a netlist and its delays. Each of its cells has
# delays; with them in Icarus the bench of the export finds the vectors right, and its outputs change later than without. What
# is wrong is told in one line, with status 2, and nothing is written. Exit 77 where a tool or the cells are missing.
set -euo pipefail
unset CDPATH
root=$(readlink -f "$1") blysk=$(readlink -f "$3") device=$4 format=$5
BLYSK_SYNTHESIS=$(readlink -f "$2")
export BLYSK_SYNTHESIS
# shellcheck source=tb/cost/icarus_sdf.sh
. "$root/tb/cost/icarus_sdf.sh"
need_tools
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export BLYSK_SYNTH_WORK=$work/synth
top=blysk_${device//-/_}_$format
"$root/scripts/synth" --sdf "$work/mine" "$device" "$format"

# The cells of both files are the same.
sed -nE 's/^  ([A-Z]+[0-9A-Z]*X[0-9]+) .*\($/\1/p' "mine/$top.v" | sort >in_netlist
sed -nE 's/^ +\(CELLTYPE "([A-Z]+[0-9A-Z]*X[0-9]+)"\)$/\1/p' "mine/$top.sdf" | sort >in_sdf
{ [ "$(wc -l <in_netlist)" -gt 100 ] && cmp in_netlist in_sdf; } || fail 'the netlist and the SDF file have different cells'

# In Icarus, with a slow clock.
"$blysk" export --device "$device" --format "$format" --output rtl >said
"$blysk" vectors --device "$device" --format "$format" --output all
sed -n '2~97p' all >vectors
sed -i '1i # some vectors' vectors
prepare_cells "mine/$top.sdf"
sed 's/#5 clk/#50 clk/' "rtl/${top}_bench.vt" >bench.vt
cat >delays.v <<END
\`timescale 1ns/1ps
module delays;
  initial if (!\$test\$plusargs("none")) \$sdf_annotate("cells.sdf", ${top}_bench.device);
  realtime loaded, latest;
  initial latest = 0;
  always @(posedge ${top}_bench.clk) loaded = \$realtime;
  always @(${top}_bench.r_o) if (\$realtime - loaded > latest) begin
    latest = \$realtime - loaded;
    \$display("latest %0.3f", latest);
  end
endmodule
END
iverilog -g2005 -gspecify -Ttyp -s "${top}_bench" -s delays -o bench bench.vt delays.v "mine/$top.v" cells.v
for run in with none; do
  vvp -n bench -sdf-warn "+vectors=vectors" "+answers=answers_$run" "+$run" >"said_$run" 2>&1
  "$blysk" check --device "$device" --format "$format" --answers "answers_$run"
  sed -n 's/^latest //p' "said_$run" | tail -n 1 >"latest_$run"
done
judge_sdf said_with
echo "latest change of red after the clock edge: $(<latest_with) ns with the delays, $(<latest_none) ns with those of the cells' models"
! cmp -s latest_with latest_none || fail 'the SDF file changes nothing'

# refused LINE ARGUMENT...: status 2, one line, nothing written.
refused() {
  local line=$1 status=0
  shift
  "$root/scripts/synth" "$@" >said 2>&1 || status=$?
  { [ "$status" = 2 ] && grep -qE -- "$line" said && [ ! -e "$work/none" ]; } || fail "status $status, expected 2 and '$line': $(<said)"
}
refused "'--sdf' expects a FOLDER" --sdf
refused "'--sdf' expects a DEVICE" --sdf "$work/none"
refused "'--sdf' expects one FORMAT" --sdf "$work/none" "$device"
BLYSK_CELLS=$work/nowhere.lib refused "nowhere.lib' is not there, expected the Liberty file" --sdf "$work/none" "$device" "$format"
: >"$work/a_file"
refused "cannot write to '$work/a_file', expected a folder" --sdf "$work/a_file" "$device" "$format"
# A library without flip-flops.
awk '/^ *cell \(DFF|^ *cell \(LATCH/ { skipping = 1 } skipping { depth += gsub(/\{/, "{") - gsub(/\}/, "}"); if (depth == 0) skipping = 0; next } { print }' \
  "$BLYSK_CELLS" >gates.lib
BLYSK_CELLS=$work/gates.lib refused 'expected (gates and a flip-flop|a library of gates and flip-flops)' --sdf "$work/none" "$device" "$format"
