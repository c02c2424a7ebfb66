#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# sphere_test.sh SPHERE DEVICE: the main job's files, and what it does where they cannot be written.
set -euo pipefail
export LC_ALL=C
sphere=$1 device=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

fail() { echo "$*" >&2 && exit 1; }

"$sphere" --side 32 --exponents 1,50 --output "it's out" >said
[ "$(ls "it's out" | paste -sd' ')" = "$device.vcd report.md sphere.png sphere_n1.png sphere_n50.png" ] || fail "files: $(ls "it's out")"
eval "set -- $(sed -n 's|^see the waves with: scripts/wave ||p' said)"
[ "$*" = "it's out/$device.vcd" ] && [ -f "$1" ] || fail "said: $(cat said)"
grep -q '^| 50 | [0-9.]*e-0[0-9] | ' "it's out/report.md" || fail 'no NMSE in the report'

# A name that is no text is shown printable, and as a word of the shell it is the name.
odd=$'a\nb\e[2J\xE9'
"$sphere" --side 32 --exponents 1 --output "$odd" >said
[ "$(LC_ALL=C.UTF-8 grep -c '[[:cntrl:]]' said)" = 0 ] && [ "$(wc -l <said)" = 5 ] || fail "said: $(cat -v said)"
eval "set -- $(sed -n 's|^see the waves with: scripts/wave ||p' said)"
[ "$*" = "$odd/$device.vcd" ] && [ -f "$1" ] || fail "said: $(cat -v said)"

# Files of names that were temporary once are left alone.
mkdir planted
echo precious >precious
sh -c 'for f in '$device'.vcd.$$.part.vcd sphere.png.$$.part report.md.$$.part; do ln -s ../precious planted/$f; done
  exec "$0" --side 32 --exponents 1 --output planted' "$sphere" >said
[ "$(cat precious)" = precious ] && [ "$(find planted -type l | wc -l)" = 3 ] && [ "$(find planted -type f | wc -l)" = 4 ] ||
  fail "planted: $(ls -l planted)"

status=0
"$sphere" --side 32 --output said 2>/dev/full || status=$?
[ "$status" = 2 ] || fail "status $status, a full standard error"

# refuses MESSAGE COMMAND...: status 2, one line, and nothing new in the folder.
refuses() {
  local message=$1 status=0 before
  shift
  before=$(find . -not -name error | sort)
  "$@" >said 2>error || status=$?
  [ "$status" = 2 ] && [ "$(wc -l <error)" = 1 ] && grep -q "$message" error || fail "status $status: $(cat error)"
  [ "$(find . -not -name error | sort)" = "$before" ] || fail "left: $(find .)"
}

mkdir -p "taken/$device.vcd"
refuses "$device.vcd: is a directory, expected a file" "$sphere" --side 32 --output taken
refuses 'said: cannot be made (Not a directory)' "$sphere" --side 32 --output said
refuses 'exponents has one twice' "$sphere" --side 32 --exponents 1,1 --output new
limited() (
  trap '' XFSZ
  ulimit -f 2
  "$sphere" --side 64 --exponents 50 --output new
)
refuses 'cannot be written' limited
