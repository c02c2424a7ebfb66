#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# lint.sh DIRECTORY TOOL...: reads an exported device with verilator, icarus or yosys. Exit 0 if none says a word.
set -euo pipefail
if [ $# -lt 2 ]; then
  echo "usage: lint.sh DIRECTORY verilator|icarus|yosys..." >&2
  exit 2
fi
cd "$1"
lists=(*.f)
list=${lists[0]}

# Yosys checks a module by itself: a loop through several shows in the flat design alone.
read_with() {
  case $1 in
    verilator) verilator --lint-only -Wall -f "$list" ;;
    icarus) iverilog -g2001 -Wall -t null -c "$list" ;;
    yosys)
      yosys -q -p "read_verilog *.v; hierarchy -check -top ${list%.f}; proc; check -assert
        select -assert-none t:\$*latch*; flatten; check -assert"
      ;;
    *) echo "lint.sh: unknown tool $1" && return 2 ;;
  esac
}

for tool in "${@:2}"; do
  status=0
  said=$(read_with "$tool" 2>&1) || status=$?
  said=$(grep -v '^- ' <<<"$said") || true # newer versions of Verilator report their own running
  if [ "$status" != 0 ] || [ -n "$said" ]; then
    printf '%s, %s:\n%s\n' "$tool" "$1" "$said" >&2
    exit 1
  fi
done
