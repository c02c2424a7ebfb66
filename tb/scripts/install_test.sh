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
"$place/bin/blysk" --version | grep -q '^blysk [0-9]'
"$place/bin/blysk" render --help | grep -q '^Usage: blysk render'
diff -r --exclude=CMakeLists.txt "$source/rtl_sysc" "$place/include/rtl_sysc"
diff -r "$source/rtl_verilog" "$place/share/blysk/rtl_verilog"
diff -r "$source/docs" "$place/share/doc/blysk/docs"
diff "$source/LICENSE" "$place/share/doc/blysk/LICENSE"
diff -r --exclude='*.vcd' "$source/vcd" "$place/share/blysk/vcd"
