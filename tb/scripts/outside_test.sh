#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# outside_test.sh SOURCE BUILD SYSTEMC CASE: a project outside of the tree builds with blysk and runs.
#   installed     docs/examples/outside against an installation, with no path into the tree
#   subdirectory  a project that adds the tree to its own: no test library, no Verilator, no other package, no setting
set -euo pipefail
source=$1 build=$2 systemc=$3 case=$4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
quietly() { "$@" >"$folder/log" 2>&1 || { cat "$folder/log" >&2 && exit 1; }; }
fail() { echo "$*" >&2 && exit 1; }
unset SystemCLanguage_DIR
export SYSTEMC_HOME=$systemc
cp -r "$source/docs/examples/outside" "$folder/outside"
case $case in
  installed)
    quietly env -u DESTDIR cmake --install "$build" --prefix "$folder/place"
    if grep -rlF --include='*.cmake' -- "$source" "$folder/place/lib"; then fail 'the package names the tree'; fi
    quietly cmake -S "$folder/outside" -B "$folder/made" -G Ninja -DCMAKE_PREFIX_PATH="$folder/place"
    ;;
  subdirectory)
    sed -i 's,^find_package(blysk.*,find_package(SystemCLanguage REQUIRED HINTS $ENV{SYSTEMC_HOME})\nadd_subdirectory("'"$source"'" blysk),' \
      "$folder/outside/CMakeLists.txt"
    disabled=()
    for package in Catch2 rapidcheck verilator CLI11 fmt nlohmann_json PNG benchmark; do
      disabled+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
    done
    quietly cmake -S "$folder/outside" -B "$folder/made" -G Ninja -DBUILD_TESTING=ON "${disabled[@]}"
    [ ! -e "$folder/made/CTestTestfile.cmake" ] || fail 'there are tests'
    grep -q '^CMAKE_BUILD_TYPE:[A-Z]*=$' "$folder/made/CMakeCache.txt" || fail 'the build type is set'
    ;;
  *) fail "no case $case" ;;
esac
quietly cmake --build "$folder/made"
# What `blysk simulate --format q8` gives for n = 10, cos = 253/256, r = 200.
printf 'n,cos,r,g,b\n10,0.98828125,200,200,200\n' >"$folder/in.csv"
expected=$("$build/bin/blysk" simulate --format q8 --stimulus "$folder/in.csv" --results - 2>"$folder/log" | sed -n '2s/.*,//p')
[ "$("$folder/made/bench" | tail -n 1)" = "$expected" ] || fail "the bench gives $("$folder/made/bench"), expected $expected"
# (7.3693868 * (0.81 - 0.9) + 0.9, 0.9^10)
[ "$("$folder/made/reflect" | sed -n 1p)" = '0.9 0.236755 0.348678' ] || fail "reflect gives $("$folder/made/reflect")"
