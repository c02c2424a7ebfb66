#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# composition.sh VERILOG_FOLDER COMPOSED FORMAT [FAULT]: proves with yosys that an exported device is what COMPOSED, its
# composed.v, says: blocks that have a formula here, wired as the figure is. Both are cut at every register, at every memory
# and at the output of every block. Between the cuts, each function of one has to be that of the other, for all inputs. A
# multiplier on both sides has the same operands then, and is not compared bit by bit. A register or a memory that one side
# lacks is a failure.
# FAULT is a sed command that spoils the device's Verilog, to see that the proof fails then.
# Exit 0 if it is proved.
set -euo pipefail
self=$(readlink -f "${BASH_SOURCE[0]}")
if [ ! -d "${1:-}" ] || [ ! -f "${2:-}" ] || [[ ! ${3:-} =~ ^q[0-9]+$ ]]; then
  sed -n '3,9s/^# //p' "$self" >&2
  exit 2
fi
fault=${4:-}
top=blysk_$(basename "$1")
# Yosys takes a blank in a path for its end: copies in the current folder have none.
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/device" "$folder/composed"
cp "$1"/*.v "$folder/device"
cp "$2" "$(dirname "$self")"/*.v* "$folder/composed"
cd "$folder"
if [ -n "$fault" ]; then
  cat device/*.v >before
  sed -i "$fault" device/*.v
  if cat device/*.v | cmp -s - before; then
    echo "composition.sh: '$fault' changes nothing, expected a fault" >&2
    exit 2
  fi
fi

# A block's words are its own matter: see module memory.
stands_for=
if grep -E '^ *memory ' composed/composed.v >lines; then stands_for=' $*memory*'; fi
memories=
for kind in rom filled_rom parted_rom line_table; do
  if compgen -G "device/${top}_${kind}_*.v" >files; then memories+=" ${top}_${kind}_*"; fi
done

# cut NAME: one module NAME whose cuts are its ports. Of the nets, outputs of blocks and registers alone keep their names.
cut() {
  echo "proc; opt -full -nodffe -nosdff; wreduce; opt_clean; flatten; opt_clean
    rename -hide w:* w:*.*_o %d t:\$dff %co1:+[Q] %d i:* %d o:* %d
    opt_clean
    expose -evert -evert-dff t:\$dff ${stands_for/ / t:}${memories// / t:}
    rename -top $1; opt_clean; design -stash $1"
}
if ! yosys -q -l log -p "
  read_verilog -Icomposed composed/*.v; chparam -set F ${3#q} composed; hierarchy -check -top composed; ${stands_for:+blackbox$stands_for}; $(cut composed)
  read_verilog device/*.v; hierarchy -check -top $top; ${memories:+blackbox$memories}; $(cut device)
  design -copy-from composed composed; design -copy-from device device
  equiv_make composed device both; hierarchy -top both; opt_clean
  equiv_struct; equiv_simple; equiv_status -assert" >errors 2>&1; then
  sed -n 's/^  Unproven .*[0-9]: \([^ ]*\).*/differs: \1/p' log | sort -u
  cat errors
  echo 'the proof did fail'
  exit 1
fi
sed -n 's/^  Of those cells \([0-9]*\) are proven.*/\1 bits of registers, outputs of blocks and ports are proved/p' log | tail -n 1
