#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# progress_test.sh BLYSK: long work shows on a terminal how far it has come, and nothing in a pipe; where results go to the
# terminal too, it keeps still. Exit 77 without `script`, which makes a terminal.
set -euo pipefail
command -v script >/dev/null || { echo 'script, which makes a terminal, is not there'; exit 77; }
blysk=$(readlink -f "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
ln -s "$blysk" blysk
failures=0
fail() {
  echo "$1"
  failures=$((failures + 1))
}
awk 'BEGIN { print "n,cos,r,g,b"; for (i = 0; i < 5000; ++i) printf "%d,%.4f,1,2,3\n", 1 + i % 1000, (i % 257) / 256 }' >rows.csv
awk 'BEGIN { print "n,cos"; for (i = 0; i < 20000; ++i) printf "%d,%.4f\n", 1 + i % 1000, (i % 257) / 256 }' >points.csv
./blysk vectors --format q8 --output vectors.txt
# The codes of red, green and blue, whatever they are: what differs is told, and that is all that matters here.
sed '2,$s/$/ 0 0 0/' vectors.txt >answers.txt

# shows WORDS ARGUMENT...: blysk says WORDS and a share on a terminal, and not in a pipe.
shows() {
  local words=$1
  shift
  script -qec "./blysk $*" terminal </dev/null >/dev/null || true
  grep -aqE "$words +[0-9]+ %" terminal || fail "blysk $1 shows no '$words' on a terminal"
  ./blysk "$@" >said 2>&1 </dev/null || true
  ! grep -aq "$words" said || fail "blysk $1 shows '$words' in a pipe"
}
shows 'simulate: bytes read' simulate --format q8 --engine systemc --stimulus rows.csv --results results.csv
shows 'model: bytes read' model blinn --points points.csv --results values.csv
shows 'vectors: written' vectors --format q8 --output again.txt
shows 'check: bytes read' check --format q8 --answers answers.txt
script -qec './blysk model blinn --points points.csv --results -' terminal </dev/null >/dev/null
! grep -aq 'bytes read' terminal || fail 'blysk model shows its progress among the results'
exit $((failures > 0))
