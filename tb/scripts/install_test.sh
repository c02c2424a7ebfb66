#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# install_test.sh SOURCE BUILD: the installation has the program, which runs, the hardware in SystemC and in Verilog, and
# the docs.
set -euo pipefail
source=$1 build=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
place=$folder/"a place"
env -u DESTDIR cmake --install "$build" --prefix "$place" >"$folder/log" || { cat "$folder/log" && exit 1; }
grep -q '^blysk [0-9]' <<<"$("$place/bin/blysk" --version)"
grep -q '^Usage: blysk render' <<<"$("$place/bin/blysk" render --help)"
diff -r --exclude=CMakeLists.txt "$source/rtl_sysc" "$place/include/blysk/rtl_sysc"
for header in "$source"/tb/golden/*.h; do diff "$header" "$place/include/blysk/tb/golden"; done
man=$(MANPATH=$place/share/man man -P cat -l "$place/share/man/man1/blysk.1" 2>/dev/null || cat "$place/share/man/man1/blysk.1")
verbs=$("$place/bin/blysk" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z-]*\) .*/\1/p')
[ -n "$verbs" ] || { echo 'blysk --help names no verb' >&2 && exit 1; }
for verb in $verbs; do
  grep -qx "${verb^^}\|\.SH \"${verb^^}\"" <<<"$man" || { echo "the manual lacks $verb" >&2 && exit 1; }
done
completed() {  # completed WORD...: what bash offers for the last word
  bash -c '. "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _blysk; echo "${COMPREPLY[*]}"' bash \
    "$place/share/bash-completion/completions/blysk" "$@"
}
[ "$(completed blysk sim)" = simulate ]
[ "$(completed blysk simulate --stim)" = --stimulus ]
[ "$(completed blysk export --format q1)" = 'q10 q12 q14 q16 q18' ]
[ "$(completed blysk simulate --engine sys)" = systemc ]
[ -n "$(completed blysk simulate --device '')" ]
diff -r "$source/rtl_verilog" "$place/share/blysk/rtl_verilog"
diff -r "$source/docs" "$place/share/doc/blysk/docs"
diff "$source/LICENSE" "$place/share/doc/blysk/LICENSE"
diff -r --exclude='*.vcd' "$source/vcd" "$place/share/blysk/vcd"
