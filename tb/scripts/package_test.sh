#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# package_test.sh BUILD: the package for Debian has the program, which runs from where it is unpacked, and names the
# libraries that it needs, but no test library and no tool.
set -euo pipefail
build=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "$*" >&2 && exit 1; }
(cd "$folder" && cpack --config "$build/CPackConfig.cmake" -B "$folder" >log 2>&1) || { cat "$folder/log" >&2 && exit 1; }
packages=("$folder"/*.deb)
[ "${#packages[@]}" = 1 ] || fail "made ${packages[*]}"
dpkg-deb -x "${packages[0]}" "$folder/root"
grep -q '^blysk [0-9]' <<<"$("$folder/root/usr/bin/blysk" --version)"
for part in bin/blysk lib/cmake/blysk/blyskConfig.cmake include/blysk/rtl_sysc/qformat.h share/man/man1/blysk.1 \
  share/bash-completion/completions/blysk; do
  [ -e "$folder/root/usr/$part" ] || fail "the package lacks $part"
done
depends=$(dpkg-deb -f "${packages[0]}" Depends)
[[ $depends == *libc6* && $depends == *libfmt* ]] || fail "depends on $depends"
[[ ! $depends =~ catch2|rapidcheck|benchmark|verilator|systemc ]] || fail "depends on $depends"
