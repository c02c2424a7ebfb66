#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# referee.sh ROOT SYNTHESIS REFEREE BLYSK DEVICE FORMAT WRITES [FAULT] [--OPTION [VALUE]]...: the engine timed beside the mapped
# netlist with its cells' delays (SDF) in Icarus, on the same writes, the device with these options. Passes if, write by write,
# both give the same outputs, the engine's outputs are busy for at least as long as the netlist's change, these never change after
# the bound, and no block of the netlist takes longer from bit to bit than its delays say.
# FAULT spoils one link of the chain, and the referee has to notice:
#   halved BLOCK     the engine gets half of the block's delays
#   sdf_error        the SDF file has a syntax error
#   unannotated      the SDF file is not read
# Exit 77 where a tool or the cells are missing.
set -euo pipefail
unset CDPATH
root=$(readlink -f "$1") synthesis=$(readlink -f "$2") referee=$(readlink -f "$3") blysk=$(readlink -f "$4")
device=$5 format=$6 writes=$7 fault='' block=''
shift 7
if [ $# -gt 0 ] && [[ $1 != --* ]]; then fault=$1 && shift; fi
if [ $# -gt 0 ] && [[ $1 != --* ]]; then block=$1 && shift; fi
chosen=(--device "$device" --format "$format" "$@")
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
# shellcheck source=tb/cost/icarus_sdf.sh
. "$here/../icarus_sdf.sh"
map_device "$synthesis" "$device" "$format" "$@"
# Of the same tools they are those that are checked in.
checked=$root/docs/tables/$place
if [ -f "$checked" ] && [ "$(tools_of "$measured")" = "$(tools_of "$checked")" ]; then
  cmp "$measured" "$checked" || fail "docs/tables/$place is stale: scripts/synth --delays $device $format $* measures it"
fi
cp "$measured" delays.json
if [ "$fault" = halved ]; then
  awk -v block="$block" '
    $1 == "\"" block "\":" { inside = 1 }
    /^    }/ { inside = 0 }
    inside && match($0, /": "[-0-9 ]+"/) {
      count = split(substr($0, RSTART + 4, RLENGTH - 5), ps, " ")
      line = substr($0, 1, RSTART + 3)
      for (i = 1; i <= count; ++i) line = line (i > 1 ? " " : "") (ps[i] == "-" ? "-" : int(ps[i] / 2))
      print line "\"" substr($0, RSTART + RLENGTH)
      changed = 1
      next
    }
    { print }
    END { exit !changed }' "$measured" >delays.json || fail "$place has no block $block"
fi

# The same writes for both, from a generator that every awk computes alike. Every third keeps n and the colours; most cosines
# lie where the highlight of n does, as elsewhere the outputs stay at 0.
bits=${format#q}
awk -v writes="$writes" -v bits="$bits" '
  function below(end) { seed = seed * 16807 % 2147483647; return seed % end }
  BEGIN {
    seed = 20261126
    print "n,cos,r,g,b" >"stimulus.csv"
    for (i = 0; i < writes; ++i) {
      if (i % 3 != 2) { n = 1 + below(1000); if (i % 4 < 3) n = 1 + n % 30; r = below(256); g = below(256); b = below(256) }
      c = i % 5 == 0 ? below(2 ^ bits + 1) : 2 ^ bits - below(int(2 ^ bits / n) + 1)
      printf "%d,%.*f,%d,%d,%d\n", n, bits, c / 2 ^ bits, r, g, b >"stimulus.csv"
      printf "%d %d %d %d %d\n", n, c, r, g, b >"writes.txt"
    }
  }'

# The engine.
"$blysk" simulate "${chosen[@]}" --engine timed --delays delays.json --stimulus stimulus.csv \
  --results results.csv --settling settling.csv --json >summary.json || { cat summary.json; exit 1; }
number() { sed -nE "s/^ *\"$1\": ([0-9.]+).*/\1/p" summary.json; }
period=$(number period_ns)

# The netlist.
prepare_cells "$mapped/delays/cells.sdf"
case $fault in
  sdf_error) sed -i '0,/(IOPATH/s//(IOPATH (/' cells.sdf ;;
esac
annotate=(+sdf=cells.sdf)
[ "$fault" != unannotated ] || annotate=()
out_bits=$(sed -nE 's/.*output wire \[([0-9]+):0\] r_o.*/\1/p' "$mapped/wrapper/mapped.v")
more=$(awk -v cycles="$(number cycles)" -v writes="$(number writes)" 'BEGIN { print int((cycles - 2) / writes) - 2 }')
half=$(awk -v period="$period" 'BEGIN { printf "%d", period * 500 }')
iverilog -g2005 -gspecify -Ttyp -s referee -o referee.vvp -DCOS_BITS=$((bits + 1)) -DOUT_BITS=$((out_bits + 1)) \
  -DHALF="$half" -DMORE="$more" "$here/referee.v" "$mapped/wrapper/mapped.v" "$mapped/delays/netlist.v" cells.v
vvp -n referee.vvp -sdf-warn +vcd=gates.vcd "${annotate[@]}" >gates.txt 2>gates.err
vvp -n referee.vvp >plain.txt 2>plain.err
cat gates.err >>gates.txt
judge_sdf gates.txt
grep -E '^[0-9]+ [0-9]+ ' gates.txt >gates.rows || fail "the netlist gave nothing: $(sed -n 1p gates.txt)"
[ "$(wc -l <gates.rows)" = "$writes" ] || fail "$(wc -l <gates.rows) writes came back of $writes"
cut -d ' ' -f 1,3- gates.rows >gates.values
grep -E '^[0-9]+ [0-9]+ ' plain.txt | cut -d ' ' -f 1,3- >plain.values || true
cmp gates.values plain.values || fail "delays change the outputs"
[ "$(cut -d ' ' -f 2 gates.rows)" != "$(grep -E '^[0-9]+ [0-9]+ ' plain.txt | cut -d ' ' -f 2)" ] ||
  fail "the delays of the SDF file change nothing: it was not read"

# Write by write.
tail -n +2 settling.csv >engine.rows
tail -n +2 results.csv >engine.values
paste -d ' ' gates.rows <(tr ',' ' ' <engine.rows) <(tr ',' ' ' <engine.values) | awk -v bits="$bits" -v bound="$(number bound_ns)" '
  {
    gate = $2 / 1000; settled = $7; busy = $8
    for (i = 0; i < 3; ++i)
      if ($(3 + i) != $(15 + i) * 2 ^ bits) { print "row " $1 ": the netlist gives " $(3 + i) ", the engine " $(15 + i) * 2 ^ bits; bad = 1; exit }
    if (busy < gate - 1e-9) { ++below; if (below == 1) first = "row " $1 ": the engine is busy for " busy " ns, the netlist changes after " gate " ns" }
    if (settled < gate - 1e-9) ++earlier
    same = NR > 1 && $3 == red && $4 == green && $5 == blue
    red = $3; green = $4; blue = $5
    if (!same) { ++others; if (settled < gate - 1e-9) ++earlier_others }
    if (gate > bound) { ++above; over = "row " $1 ": the netlist changes after " gate " ns, the bound is " bound " ns" }
    if (gate > worst) worst = gate
    if (settled > worst_settled) worst_settled = settled
    if (busy > worst_busy) worst_busy = busy
    sum += gate; sum_settled += settled
  }
  END {
    if (bad) exit 1
    printf "%d writes: netlist up to %.3f ns, mean %.3f; engine up to %.3f ns, mean %.3f, busy up to %.3f ns; bound %.3f ns\n", NR, worst, sum / NR, worst_settled, sum_settled / NR, worst_busy, bound
    printf "the last change of the engine comes before that of the netlist in %d writes, in %d of the %d that change the outputs; the end of its activity in %d\n", earlier, earlier_others, others, below
    if (above) print over
    if (below) print first
    exit above || below
  }'
"$referee" delays.json "$mapped/delays/netlist.json" gates.vcd
