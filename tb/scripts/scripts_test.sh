#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# scripts_test.sh SOURCE CASE [LAYOUT_SHOWS]: the scripts in a copy of the tree that is fast to build, with stand-ins for the tools that
# install, draw or take long.
set -euo pipefail
export LC_ALL=C
unset SystemCLanguage_DIR XDG_CACHE_HOME SUDO_UID CDPATH
export SYSTEMC_HOME=/stands/in
source=$1 case=$2 layout_shows=${3:-}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
folder=$folder/"a folder"
mkdir -p "$folder/stubs"
cd "$folder"
PATH=$folder/stubs:$PATH

fail() { echo "$*" >&2 && exit 1; }

# stub NAME: a tool whose script is standard input.
stub() { { echo '#!/bin/bash' && cat; } >"$folder/stubs/$1" && chmod +x "$folder/stubs/$1"; }

# Every package is installed.
stub dpkg-query <<'END'
printf 'installed %s\n' "${@:4}"
END

# tree NAME: the scripts, and a project that makes the file `built`.
tree() {
  mkdir -p "$1"
  mkdir -p "$1/tb"
  cp -R "$source/scripts" "$source/CMakePresets.json" "$source/.clang-tidy" "$source/vcd" "$1"
  cp "$source/tb/formats.def" "$1/tb"
  cat >"$1/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(tiny NONE)
add_custom_target(everything ALL COMMAND ${CMAKE_COMMAND} -E touch ${CMAKE_SOURCE_DIR}/built)
END
}

# exits STATUS COMMAND...: with its output in said and error.
exits() {
  local expected=$1 status=0
  shift
  "$@" >"$folder/said" 2>"$folder/error" || status=$?
  [ "$status" = "$expected" ] || fail "$*: status $status, expected $expected; $(cat "$folder/said" "$folder/error")"
}
one_line() { [ "$(wc -l <error)" = 1 ] && grep -qF -- "$1" error || fail "expected one line with $1: $(cat error)"; }

case $case in
  arguments)
    tree tree
    stub ctest <<END
echo "\$*" >'$folder/arguments'
END
    for script in build check-includes describe-program figures fuzz gtkwave-screenshot lint run sanitize setup stability synth test wave; do
      exits 0 "tree/scripts/$script" a b --help
      grep -q '^Usage: scripts/'$script said || fail "$script has no help: $(cat said)"
      [ "$script" = run ] && continue # its options are the program's
      exits 2 "tree/scripts/$script" --nonsense
      one_line --nonsense
      one_line "scripts/$script --help"
      exits 2 "tree/scripts/$script" a b c d e
      [ "$(wc -l <error)" = 1 ] || fail "$script with five arguments: $(cat error)"
    done
    exits 2 tree/scripts/wave nosuch.vcd
    one_line 'there is no file nosuch.vcd, expected a waveform'
    echo 'n,cos' >table.csv
    exits 2 tree/scripts/wave table.csv
    one_line 'table.csv declares no signals, expected a waveform'
    printf '$enddefinitions $end\n' >loop.vcd
    exits 2 tree/scripts/gtkwave-screenshot loop.vcd table.csv ./table.csv
    one_line 'table.csv is read too'
    [ "$(cat table.csv)" = n,cos ] || fail 'a picture in place of a layout'
    printf '$comment\r\nblysk-device --device some --format q8\r\n$end\r\n$enddefinitions $end\r\n' >crlf.vcd
    exits 0 bash -c '. tree/scripts/lib.sh; device_of_waves crlf.vcd'
    [ "$(cat said)" = '--device some --format q8' ] || fail "of lines that end in CR LF: $(cat said)"
    exits 2 tree/scripts/run --format q99
    one_line "format 'q99' does not exist, expected q8 q10 q12"
    for name in output report compare vcd; do
      exits 2 tree/scripts/run --size 8x8 --$name x
      one_line "'--$name' names a result"
    done
    [ ! -e tree/build ] || fail 'a wrong argument configures'
    exits 1 tree/scripts/describe-program /bin/true described
    one_line '/bin/true --help names no verb'
    exits 1 tree/scripts/describe-program /nonexistent described
    one_line '/nonexistent --help names no verb'
    [ ! -e described ] || fail 'a folder for nothing'
    for script in stability fuzz sanitize; do
      exits 2 tree/scripts/$script $([ $script != sanitize ] || echo asan) $([ $script != fuzz ] || echo --folder) table.csv/x
      one_line "cannot make the folder '"
    done
    exits 2 tree/scripts/gtkwave-screenshot $'a\e[2J\nb\xE9' b c
    one_line 'cannot read'
    [ "$(tr -d '\n' <error | tr -dc '\000-\037\177-\377' | wc -c)" = 0 ] || fail "not printable: $(cat -v error)"

    # given EXPECTED ARGUMENT...: what scripts/test hands to ctest.
    given() {
      local expected=$1
      shift
      exits 0 tree/scripts/test "$@"
      [ "$(cat arguments)" = "--test-dir build --output-on-failure --no-tests=error $expected" ] || fail "$*: $(cat arguments)"
    }
    exits 2 tree/scripts/test --quik
    one_line "'--quik' is unknown"
    [ ! -e arguments ] && [ ! -e tree/built ] || fail 'a wrong option starts work'
    given '-j 2 -LE ^long$'
    given '-j 2 -L ^quick$ -LE ^long$' --quick
    given "-j 2 --output-junit $folder/tree/build/long.xml" --long
    given '-j 2 -LE ^long$ -R cosim -V' -R cosim -V
    given '-j 7 -LE ^long$|lint -I 3,4' -j 7 -LE lint -- -I 3,4
    exits 2 tree/scripts/test -R cosim --quick -E
    ;;
  moved_tree)
    build() { exits 0 bash -c '. "$1/scripts/lib.sh"; build' build "$1"; }
    tree one
    build one
    [ -e one/built ] || fail 'nothing built'
    rm one/built
    cp -a one two
    build two
    [ -e two/built ] && [ ! -e one/built ] || fail 'a copy builds what it was copied from'
    rm two/built
    mv two three
    build three
    [ -e three/built ] || fail 'a tree that was moved does not build'
    build three
    ! grep -q configuring error || fail 'configured without need'
    ln -s three link
    build link
    ! grep -q configuring error || fail 'configured for a link to the tree'
    ;;
  part)
    tree tree
    cat >>tree/CMakeLists.txt <<'END'
add_custom_target(some)
file(WRITE ${CMAKE_BINARY_DIR}/has "formats ${BLYSK_FORMATS}, engine verilator ${BLYSK_VERILATED}, tests ${BUILD_TESTING}")
END
    # has WHAT FUNCTION ARGUMENT...: what build/ is configured for after a call.
    has() {
      exits 0 bash -c '. tree/scripts/lib.sh; "$@"' part "${@:2}"
      [ "$(cat tree/build/has)" = "$1" ] || fail "${*:2}: $(cat tree/build/has), expected $1"
    }
    as_it_was() {
      ! grep -q configuring error || fail 'configured without need'
    }
    has 'formats q16, engine verilator OFF, tests OFF' build_part q16 some
    has 'formats q16, engine verilator OFF, tests OFF' build_part q16 some
    as_it_was
    has 'formats q16;q8, engine verilator OFF, tests OFF' build_part q8 some
    has 'formats q16;q8, engine verilator OFF, tests OFF' build_part q16 some
    as_it_was
    has 'formats , engine verilator ON, tests ON' build some
    has 'formats , engine verilator ON, tests ON' build_part q8 some
    as_it_was
    has 'formats , engine verilator ON, tests ON' build
    as_it_was
    exits 2 bash -c '. tree/scripts/lib.sh; build_part q99 some'
    one_line "format 'q99' does not exist, expected q8"
    has 'formats , engine verilator ON, tests ON' build
    ;;
  cdpath)
    tree tree
    cd tree
    CDPATH=.:.. exits 0 scripts/build
    [ -e built ] || fail 'nothing built'
    ;;
  home)
    unset SYSTEMC_HOME
    tree tree
    stub apt-get <<<'exit 1'
    stub curl <<'END'
while [ "$1" != -o ]; do shift; done
echo archive >"$2"
END
    stub sha256sum <<<'cat >/dev/null'
    stub tar <<<'exit 0'
    stub cmake <<'END'
for word; do
  case $word in
    -DCMAKE_INSTALL_PREFIX=*) mkdir -p "${word#*=}" ;;
  esac
done
END
    for home in 'env -u HOME' 'env HOME=/dev/null/home' 'env HOME=relative' 'env HOME=/dev/null/home XDG_CACHE_HOME=relative'; do
      rm -rf tree/build
      # shellcheck disable=SC2086
      exits 0 $home tree/scripts/setup
      ls tree/build/deps/cache/blysk/systemc-*.tar.gz >/dev/null || fail "$home: the archive is elsewhere"
      [ -e tree/build/deps/systemc/.complete ] || fail "$home: nothing installed"
      [ ! -e relative ] && [ ! -e '~' ] || fail "$home: made a folder where it was called"
    done
    rm -rf tree/build
    exits 0 env HOME="$folder/home" tree/scripts/setup
    ls home/.cache/blysk/systemc-*.tar.gz >/dev/null || fail 'the archive is not in ~/.cache'
    ;;
  layout)
    tree tree
    # What follows the header is no header.
    cat >waves.vcd <<'END'
$comment
blysk-device --device some-device --format q12 --as-published
$end
$scope module SystemC $end
$var wire 1 aaa clk $end
$scope module rg1 $end
$var wire 10 aac q_o [9:0] $end
$upscope $end
$upscope $end
$enddefinitions $end
blysk-device --device other --format q8
$scope module SystemC $end
$var wire 31 aab cos18 [30:0] $end
END
    names() {
      exits 0 bash -c '. tree/scripts/lib.sh; device_of_waves "$1"' names "$1"
      [ "$(cat said)" = "$2" ] || fail "$1: $(cat said)"
    }
    names waves.vcd '--device some-device --format q12 --as-published'
    sed 's/^blysk-device.*/blysk-device --device some-device --cuts 2,5 --format q8/' waves.vcd >cuts.vcd
    names cuts.vcd '--device some-device --cuts 2,5 --format q8'
    # A terabyte of waves takes no time.
    cp waves.vcd large.vcd
    truncate -s 1T large.vcd
    names large.vcd '--device some-device --format q12 --as-published'
    sed 's/SystemC/TOP/; s/^blysk-device.*/blysk-device $(touch owned)/' waves.vcd >other.vcd
    names other.vcd ''
    ;;
  screenshot)
    tree tree
    cat >>tree/CMakeLists.txt <<END
add_custom_target(layout_shows COMMAND \${CMAKE_COMMAND} -E create_symlink "$layout_shows" \${CMAKE_BINARY_DIR}/bin/layout_shows)
file(MAKE_DIRECTORY \${CMAKE_BINARY_DIR}/bin)
END
    stub Xvfb <<'END'
echo 7 >&3
exec sleep 60
END
    stub gtkwave <<'END'
echo 'blysk: 40 traces'
head -c 20000 /dev/zero >"$PICTURE"
END
    layouts=(tree/vcd/*.gtkw)
    printf '%s\n' ' $scope module TOP $end' '  $var wire 1 # clk $end' ' $upscope $end' '$enddefinitions $end' >waves.vcd
    exits 2 tree/scripts/gtkwave-screenshot waves.vcd "${layouts[0]}" picture.png
    [[ $(tail -n 1 error) == *'shows no signal of waves.vcd' ]] || fail "no reason: $(cat error)"
    [ ! -e picture.png ] || fail 'a picture was made'
    sed -i 's/TOP/SystemC/' waves.vcd
    exits 0 tree/scripts/gtkwave-screenshot waves.vcd "${layouts[0]}" picture.png
    [ -e picture.png ] || fail 'no picture was made'
    ;;
  lint)
    tree tree
    # Notes what it is to check, and whether the database has one command for it.
    stub clang-tidy <<END
if [ "\$1" = --version ]; then echo 'LLVM version 14.0.6' && exit; fi
for word; do [ "\$before" = -p ] && database=\$word; before=\$word; done
echo "\${word##*/} \$(grep -o '"file"' "\$database/compile_commands.json" | wc -l)" >>'$folder/calls'
exit \$(cat '$folder/verdict')
END
    mkdir -p tree/tb build
    echo '#include "b.h"' >tree/tb/a.cpp
    echo 'int c;' >tree/tb/c.cpp
    echo 'int b;' >tree/tb/b.h
    root=$folder/tree
    # database FLAGS: as CMake writes it, a.cpp for two formats.
    database() {
      for entry in a:q8 a:q10 c:q8; do
        file=$root/tb/${entry%:*}.cpp
        printf '{\n  "directory": "%s",\n  "command": "g++ %s -DF=%s -DT=\\\\\\"t\\\\\\" -o %s.o -c %s",\n  "file": "%s"\n},\n' \
          "$folder/build" "$1" "${entry#*:}" "$entry" "$(sed 's/ /\\\\ /g' <<<"$file")" "$file"
      done >build/compile_commands.json
    }
    # checked STATUS WHAT EXPECTED...: the sources that the check of now looks at.
    checked() {
      local status=$1 what=$2 expected
      shift 2
      expected=$([ $# = 0 ] || printf '%s.cpp 1\n' "$@")
      rm -f calls && touch calls
      exits "$status" tree/scripts/lint tidy "$folder/build"
      [ "$(sort calls)" = "$expected" ] || fail "$what: $(cat calls), expected $expected"
    }
    database -O1
    echo 0 >verdict
    checked 0 'a source once' a c
    [ -z "$(find build -name '*.o')" ] || fail 'the check writes objects'
    checked 0 'nothing twice'
    touch tree/tb/*
    checked 0 'times do not count'
    echo 'int d;' >tree/tb/b.h
    checked 0 'a header' a
    echo '# other' >>tree/.clang-tidy
    checked 0 'the configuration' a c
    database -O2
    checked 0 'the commands' a c
    echo 1 >verdict
    checked 0 'nothing changed, nothing to find'
    echo 'int e;' >tree/tb/c.cpp
    checked 123 'a fault' c
    checked 123 'a fault is found again' c
    echo 0 >verdict
    checked 0 'until it is mended' c
    checked 0 'and then no more'
    exits 2 tree/scripts/lint tidy no/build
    one_line "cannot enter 'no/build', expected a configured build folder"
    exits 1 tree/scripts/lint tidy stubs
    one_line compile_commands.json
    ;;
  timescale)
    # As docs/verilog.md has it.
    command=$(sed -n 's/^ *`\(verilator .*--timescale .*\) tb.v`;.*/\1/p' "$source/docs/verilog.md")
    top=$(sed -n 's/.*-f \(blysk_[a-z0-9_]*\)\.f.*/\1/p' <<<"$command")
    [ -n "$top" ] || fail 'docs/verilog.md has no such command'
    printf '`timescale 1ns/1ps\nmodule tb;\n  %s dut ();\nendmodule\n' "$top" >tb.v
    cp -R "$source/rtl_verilog/${top#blysk_}" rtl
    cp tb.v rtl
    cd rtl
    $command -Wno-PINMISSING tb.v
    ! ${command/--timescale 1ns\/1ps/} -Wno-PINMISSING tb.v 2>error || fail 'it is not needed'
    grep -q TIMESCALEMOD error
    # In a path without a blank, which Verilator's lists do not take.
    cp -R "$source/rtl_verilog/${top#blysk_}" "$folder/../rtl_elsewhere"
    (cd / && verilator --lint-only -Wall -F "$(readlink -f "$folder/..")/rtl_elsewhere/$top.f") || fail 'the list cannot be read from another folder'
    ;;
  line_ends)
    git -C "$source" rev-parse 2>/dev/null || exit 77 # no clone
    git -C "$source" ls-files --eol |
      awk '!/^i\/(lf|none) *w\/(lf|none|crlf) *attr\/text=auto eol=lf/ && !/attr\/-text/ { print; bad = 1 } END { exit bad }'
    git -C "$source" ls-files --eol '*.png' | awk '!/attr\/-text/ { print; bad = 1 } END { exit bad }'
    ;;
  *) fail "no case $case" ;;
esac
