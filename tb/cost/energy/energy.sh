#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# energy.sh ROOT SYNTHESIS ENERGY check|update DEVICE FORMAT [--OPTION VALUE]... [FAULT]: how often the nets of a device change
# for a result, and what energy its cells take: the mapped netlist in Icarus with its cells' delays (SDF) and without, OpenSTA
# on the changes that were counted. update writes docs/tables/DEVICE/energy_FORMAT.json, check compares with it.
# It is a measurement only if the SDF file was read without an error, the delays change no output, and both runs take equally
# many clock cycles. FAULT spoils one link of that chain, and it has to be noticed: sdf_error, unannotated, other_outputs.
# Exit 77 where a tool or the cells are missing or others than those of the file.
set -euo pipefail
unset CDPATH
root=$(readlink -f "$1") synthesis=$(readlink -f "$2") energy=$(readlink -f "$3")
action=$4
shift 4
fault=''
case ${*: -1} in
  sdf_error | unannotated | other_outputs)
    fault=${*: -1}
    set -- "${@:1:$#-1}"
    ;;
esac
device=$1 format=$2
chosen=(--device "$device" --format "$format" "${@:3}")
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
rows=256 warm=16
# shellcheck source=tb/cost/icarus_sdf.sh
. "$here/../icarus_sdf.sh"
map_device "$synthesis" "$device" "$format" "${@:3}"
row=$root/docs/tables/${place/delays_/energy_}
if [ "$action" = check ]; then
  [ -f "$row" ] || fail "$row is missing: the target update_energy measures it"
  [ "$(tools_of "$measured")" = "$(tools_of "$row")" ] || { echo "the tools are others than those of $row"; exit 77; }
fi

# Rows of three kinds. random: all codes alike. line: a scan line through a highlight of n = 50. sphere: pixels of a lit sphere.
bits=${format#q}
awk -v rows=$((rows + warm + 1)) -v bits="$bits" '
  function below(end) { seed = seed * 16807 % 2147483647; return seed % end }
  function code(c) { return c <= 0 ? 0 : int(c * 2 ^ bits + 0.5) }
  BEGIN {
    seed = 20261126
    for (i = 0; i < rows; ++i)
      printf "%d %d %d %d %d\n", 1 + below(1000), below(2 ^ bits + 1), below(256), below(256), below(256) >"random.txt"
    for (i = 0; i < rows; ++i) printf "50 %d 255 200 120\n", code(cos(1.6 * (i / (rows - 1) - 0.5))) >"line.txt"
    size = 24
    for (y = 0; y < size; ++y)
      for (x = 0; x < size && i < 2 * rows; ++x) {
        u = (2 * x + 1 - size) / size; v = (2 * y + 1 - size) / size; w = 1 - u * u - v * v
        if (w < 0 || y < 4) continue
        printf "50 %d 255 200 120\n", code((0.3 * u - 0.3 * v + sqrt(w)) / sqrt(1.18)) >"sphere.txt"
        ++i
      }
  }'

prepare_cells "$mapped/delays/cells.sdf"
[ "$fault" != sdf_error ] || sed -i '0,/(IOPATH/s//(IOPATH (/' cells.sdf
annotate=(+sdf=cells.sdf)
[ "$fault" != unannotated ] || annotate=()
cp "$mapped/delays/netlist.v" plain.v
[ "$fault" != other_outputs ] || sed -i 's/NAND2X1/NOR2X1/' plain.v
out_bits=$(sed -nE 's/.*output wire \[([0-9]+):0\] r_o.*/\1/p' "$mapped/wrapper/mapped.v")
half=$("$energy" half "$measured")
macros=(-DCOS_BITS=$((bits + 1)) -DOUT_BITS=$((out_bits + 1)) -DHALF="$half" "-DROWS=$rows" "-DWARM=$warm")
settles=$("$energy" more "${chosen[@]}")
if [ "$settles" = pipelined ]; then macros+=(-DPIPELINED); else macros+=(-DMORE="$settles"); fi
bench=("$here/energy.v" "$mapped/wrapper/mapped.v")
compile() { iverilog -g2005 -s energy "${macros[@]}" "$@" "${bench[@]}" cells.v >said 2>&1 || { cat said; exit 1; }; }
compile -gspecify -Ttyp -o delayed.vvp "$mapped/delays/netlist.v"
compile -o plain.vvp plain.v
for kind in random line sphere; do
  cp $kind.txt writes.txt
  [ "$(wc -l <writes.txt)" -gt $((rows + warm)) ] || fail "$kind has too few rows"
  vvp -n delayed.vvp -sdf-warn "+vcd=$kind.delayed.vcd" "${annotate[@]}" >$kind.delayed 2>$kind.errors
  vvp -n plain.vvp "+vcd=$kind.plain.vcd" >$kind.plain 2>&1
  cat $kind.errors >>$kind.delayed
  judge_sdf $kind.delayed
  for run in delayed plain; do
    grep -E '^[0-9]+ [0-9]+ [0-9]+$' $kind.$run >$kind.$run.values || fail "the netlist gave nothing: $(sed -n 1p $kind.$run)"
    grep 'results in' $kind.$run >$kind.$run.cycles || fail "the netlist did not come to its end: $(sed -n 1p $kind.$run)"
  done
  [ "$(wc -l <$kind.delayed.values)" -ge $rows ] || fail "$(wc -l <$kind.delayed.values) results of $rows"
  cmp -s $kind.delayed.values $kind.plain.values || fail "$kind: the delays change the outputs"
  cmp -s $kind.delayed.cycles $kind.plain.cycles || fail "$kind: the delays change the cycles"
  cycles=$(sed -nE 's/.* in ([0-9]+) cycles/\1/p' $kind.plain.cycles)
  for run in delayed plain; do
    "$energy" activity "$mapped/delays/netlist.json" "$mapped/delays/cells.lib" $kind.$run.vcd "$cycles" --toggles $kind.$run.toggles >activity.tcl
    {
      printf 'read_liberty %s/delays/cells.lib\nread_verilog %s/delays/netlist.v\nlink_design %s\n' "$mapped" "$mapped" "$(<"$mapped/top")"
      echo "create_clock -name clk -period $(awk -v half="$half" 'BEGIN { printf "%.3f", 2 * half / 1000 }') [get_ports clk]"
      # set_power_activity -pins of OpenSTA 2.0.17 calls a command that it does not have.
      # shellcheck disable=SC2016  # Tcl's own sign
      echo 'proc activity {pin changes} {sta::set_power_pin_activity [get_pins $pin] $changes 0.5}'
      cat activity.tcl
      echo 'report_power -digits 6 -instances [get_cells -hierarchical *]'
    } >watts.tcl
    sta -no_init -no_splash -exit watts.tcl >$kind.$run.watts 2>&1 || fail "OpenSTA: $(tail -n 1 $kind.$run.watts)"
    ! grep -iE '^(error|warning)' $kind.$run.watts >others.txt || fail "OpenSTA: $(sed -n 1p others.txt)"
  done
  echo "$kind $cycles" >>kinds.txt
done
# The cells have delays of their own, which the SDF file replaces.
vvp -n delayed.vvp +vcd=own.vcd >said
if tail -n +4 own.vcd | cmp -s - <(tail -n +4 "$kind.delayed.vcd"); then
  fail "the delays of the SDF file change nothing: it was not read"
fi
"$energy" collect "$measured" "$rows" "$half" kinds.txt >made.json
if [ "$action" = check ]; then
  diff "$row" made.json
else
  mkdir -p "${row%/*}"
  cmp -s made.json "$row" || cp made.json "$row"
fi
