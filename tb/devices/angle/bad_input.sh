#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bad_input.sh BLYSK: what `angle` and its stimulus refuse: one line on standard error, status 2, and no results.
set -euo pipefail
[ $# = 1 ] || { sed -n '3s/^# //p' "$0" >&2 && exit 2; }
blysk=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
status=0

# refuses WORDS ROW [OPTION]...: the message has the words.
refuses() {
  local words=$1 row=$2 code=0
  shift 2
  printf '%s\n%s\n' "${head:-n,intensity,start,step,count}" "$row" >"$folder/in.csv"
  "$blysk" simulate --device angle --format q8 --stimulus "$folder/in.csv" --results "$folder/out.csv" "$@" \
    >"$folder/out" 2>"$folder/message" || code=$?
  if [ $code != 2 ] || [ "$(wc -l <"$folder/message")" != 1 ] || [ -e "$folder/out.csv" ] || [ -s "$folder/out" ] ||
    ! grep -qF -- "$words" "$folder/message"; then
    printf '%s, %s: status %s, expected 2 and a line with: %s\n' "$row" "$*" $code "$words"
    cat "$folder/message"
    rm -f "$folder/out.csv"
    status=1
  fi
}

good=10,255,0.5,0.01,4
refuses '--q is 1, expected' $good --q 1
refuses '--q is 0, expected' $good --q 0
refuses '--q is -0.5, expected' $good --q=-0.5
refuses '--k is 0, expected an integer 1..15' $good --k 0
refuses '--k is 16, expected an integer 1..15' $good --k 16
refuses '--energy is some, expected none, published, exact, safe' $good --energy some
refuses '--energy published holds for --q in [0.1, 0.4] or [0.5, 0.9] and --k in 1..5' $good --energy published --q 0.45
refuses '--energy published holds for --q in [0.1, 0.4] or [0.5, 0.9] and --k in 1..5' $good --energy published --k 6
refuses 'expected an integer 1..1023' 10,255,0.5,0.01,0
refuses 'expected an integer 1..1023' 10,255,0.5,0.01,1024
refuses 'expected an integer 1..1000' 0,255,0.5,0.01,4
refuses 'expected a real number in [0, 1.57' 10,255,1.58,0.01,4
refuses 'expected a real number in [0, 1.57' 10,255,-0.1,0.01,4
refuses 'expected a real number in [-0.125' 10,255,0.5,0.125,4
head=n,cos,r,g,b refuses 'n,intensity,start,step,count' 10,1,1,1,1
exit $status
