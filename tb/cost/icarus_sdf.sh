# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# A mapped netlist with its cells' delays in Icarus: what the referee and the measurement of energy share. Sourced; the caller
# has set root.
export LC_ALL=C BLYSK_CELLS=${BLYSK_CELLS:-$root/build/deps/osu018/osu018_stdcells.lib}
fail() { echo "$*"; exit 1; }

# need_tools: exit 77 where a tool or the cells of BLYSK_CELLS are missing.
need_tools() {
  local tool file
  for tool in yosys sta iverilog; do
    command -v $tool >/dev/null || { echo "$tool is not there: scripts/setup --synthesis installs it"; exit 77; }
  done
  for file in "$BLYSK_CELLS" "${BLYSK_CELLS%.lib}.v"; do
    [ -f "$file" ] || { echo "${file##*/} is not there: scripts/setup --synthesis fetches it"; exit 77; }
  done
}

# tools_of ROW: what a row of docs/tables was measured with.
tools_of() { sed -n '/"tools"/,/}/p' "$1"; }

# map_device SYNTHESIS DEVICE FORMAT [--OPTION [VALUE]]...: the mapped netlist and its delays, made anew in an empty folder, which
# is the current one from then on. Sets place, the delays' file below docs/tables, measured, the file itself, and mapped, the
# folder of the netlist.
map_device() {
  local synthesis=$1
  shift
  need_tools
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
  cd "$folder" || exit
  BLYSK_SYNTHESIS=$synthesis BLYSK_ROWS=$folder/rows BLYSK_SYNTH_WORK=$folder/work \
    "$root/scripts/synth" --delays "$@" >said 2>&1 || { cat said; exit 1; }
  place=$("$synthesis" path --kind delays --device "$1" --format "$2" "${@:3}")
  # shellcheck disable=SC2034  # the caller's
  measured=$folder/rows/$place mapped=$folder/work/${place%.json}
  [ -f "$measured" ] || { cat said; exit 1; }
}

# prepare_cells SDF: cells.sdf and cells.v. Icarus wants a middle value, and no wires at the top; the cells' time step would
# round every arc.
prepare_cells() {
  awk '
    /^ \(CELL$/ { getline type; if (type ~ /CELLTYPE "blysk_/) { skipping = 1; next } skipping = 0; print; print type; next }
    /^\)/ { skipping = 0 }
    !skipping { print }' "$1" | sed -E 's/\(([-0-9.]+)::([-0-9.]+)\)/(\1:\2:\2)/g' >cells.sdf
  [ "$(grep -c IOPATH cells.sdf)" -gt 100 ] || fail "the SDF file has next to no delays"
  # shellcheck disable=SC2016  # Verilog's own sign
  sed 's,^`timescale.*,`timescale 1ns/1ps,' "${BLYSK_CELLS%.lib}.v" >cells.v
}

# judge_sdf SAID: what Icarus said of cells.sdf. Two pins of a cell at one net, as the square has, are one path to it: it keeps
# the first and warns of the second.
judge_sdf() {
  local arcs unmatched
  grep -iE 'sdf (error|warning)' "$1" >faults.txt || true
  ! grep -v 'Unable to match ModPath' faults.txt >others.txt || fail "Icarus reports of the SDF file: $(sed -n 1p others.txt)"
  arcs=$(grep -c IOPATH cells.sdf || true) unmatched=$(wc -l <faults.txt)
  [ $((unmatched * 1000)) -le "$arcs" ] || fail "$unmatched of $arcs delays found no path in Icarus: $(sed -n 1p faults.txt)"
}
