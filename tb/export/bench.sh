#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bench.sh BLYSK DIRECTORY DEVICE FORMAT icarus|verilator: the test bench beside an export puts vectors into it, and
# `blysk check` finds the answers equal, and one that is changed different.
set -euo pipefail
blysk=$(readlink -f "$1")
directory=$(readlink -f "$2")
device=$3 format=$4
lists=("$directory"/*.f)
top=$(basename "${lists[0]}" .f)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$directory"
mapfile -t sources <"$top.f"
sources+=("${top}_bench.vt")
# Some of the vectors of each kind; without the header, which counts them.
"$blysk" vectors --device "$device" --format "$format" --output "$work/all"
sed -n '2~37p' "$work/all" >"$work/vectors"
sed -i '1i # some vectors' "$work/vectors"
case $5 in
  icarus)
    iverilog -g2001 -s "${top}_bench" -o "$work/bench" "${sources[@]}"
    run=(vvp -n "$work/bench")
    ;;
  verilator)
    verilator --binary --timing -Wno-fatal --top-module "${top}_bench" --Mdir "$work/made" -o bench "${sources[@]}" \
      >"$work/log" 2>&1 || { cat "$work/log" >&2 && exit 1; }
    run=("$work/made/bench")
    ;;
esac
"${run[@]}" +vectors="$work/vectors" +answers="$work/answers" >"$work/log"
"$blysk" check --device "$device" --format "$format" --answers "$work/answers"
# One digit of the last answer changed is a difference, and a line less an answer that is missing or shorter.
tail -n 1 "$work/answers" | tr '[0-9a-f]' '[1-9a-f0]' >"$work/last"
paste -d ' ' <(tail -n 1 "$work/answers" | sed 's/ [^ ]*$//') <(sed 's/.* //' "$work/last") >"$work/changed"
{ sed '$d' "$work/answers" && cat "$work/changed"; } >"$work/wrong"
status=0
"$blysk" check --device "$device" --format "$format" --answers "$work/wrong" >"$work/log" 2>&1 || status=$?
# What a port cannot carry is no answer.
[ "$status" = 1 ] || { [ "$status" = 2 ] && grep -q 'expected hexadecimal digits of [0-9]* bits$' "$work/log"; } ||
  { echo "a changed answer: status $status" >&2 && cat "$work/log" >&2 && exit 1; }
# A device that draws scan lines answers with a line for each pixel: one that is missing is noticed.
if [ "$(wc -l <"$work/answers")" -gt "$(wc -l <"$work/vectors")" ]; then
  sed '$d' "$work/answers" >"$work/short"
  status=0
  "$blysk" check --device "$device" --format "$format" --answers "$work/short" >"$work/log" 2>&1 || status=$?
  [ "$status" = 2 ] && grep -q 'is the end of the answers, expected 1 pixels more of its vector$' "$work/log" ||
    { cat "$work/log" >&2 && exit 1; }
fi
# Without vectors it leaves no answers of an earlier run that someone could judge.
status=0
"${run[@]}" +vectors="$work/nothing" +answers="$work/answers" >"$work/log" 2>&1 || status=$?
grep -q 'nothing cannot be read, expected what blysk vectors writes' "$work/log" || { cat "$work/log" >&2 && exit 1; }
[ -e "$work/answers" ] && [ ! -s "$work/answers" ] || { echo 'answers of an earlier run are left' >&2 && exit 1; }
