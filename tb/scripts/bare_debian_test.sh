#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bare_debian_test.sh SOURCE BUILD SYSTEMC DEVICE: the package for Debian is installed on a Debian 12 that has nothing but its base
# system. There the program computes with each engine, an outside project is built on the headers and the library, and the
# package is removed again. Debian comes through debootstrap from DEBIAN_MIRROR, or from its own default.
# Status 77: not root, no debootstrap, or no mirror.
set -euo pipefail
source=$1 build=$2 systemc=$3 device=$4
skip() { echo "skipped: $*" && exit 77; }
fail() { echo "$*" >&2 && exit 1; }
[ "$(id -u)" = 0 ] || skip "only root may make the root of a Debian"
command -v debootstrap >/dev/null || skip "debootstrap is not installed"
folder=$(mktemp -d)
trap 'rm -rf --one-file-system "$folder"' EXIT
root=$folder/root
quietly() { "$@" >"$folder/log" 2>&1 </dev/null || { tail -n 20 "$folder/log" >&2 && return 1; }; }
quietly debootstrap --variant=minbase bookworm "$root" ${DEBIAN_MIRROR:+"$DEBIAN_MIRROR"} ||
  skip "debootstrap made no Debian 12"
cp -r /etc/apt/apt.conf.d "$root/etc/apt/" # how this machine reaches its mirror
(cd "$folder" && quietly cpack --config "$build/CPackConfig.cmake" -B "$folder") || fail "no package was made"
cp "$folder"/*.deb "$root/tmp/blysk.deb"
cp "$source/docs/examples/fig3.csv" "$root/tmp/"
cp -rL "$systemc" "$root/opt/systemc"

inside() { quietly env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 device="$device" chroot "$root" sh -euxc "cd /tmp; $1"; }
inside 'apt-get update; apt-get install -y --no-install-recommends ./blysk.deb'
for tool in verilator c++; do
  if [ -e "$root/usr/bin/$tool" ]; then fail "the package brought $tool"; fi
done
# shellcheck disable=SC2016 # the shell inside expands
inside '
  for engine in golden bit systemc verilator; do
    blysk simulate --device $device --format q16 --engine $engine --stimulus fig3.csv --results $engine.csv
  done
  cmp bit.csv systemc.csv
  cmp bit.csv verilator.csv
  if cmp -s bit.csv golden.csv; then exit 1; fi
  blysk simulate --device $device --engine systemc --stimulus fig3.csv --results s.csv --vcd s.vcd
  blysk export --device $device --format q8 --output verilog
  test -s verilog/blysk_$(echo $device | tr - _)_q8.v
  blysk render sphere --size 64x64 --output sphere.png
  test -s sphere.png'
inside '
  apt-get install -y --no-install-recommends g++ cmake make libboost-dev
  cp -r /usr/share/doc/blysk/docs/examples/outside .
  export SYSTEMC_HOME=/opt/systemc
  cmake -S outside -B outside/build
  cmake --build outside/build
  outside/build/bench
  outside/build/reflect'
inside 'apt-get remove -y blysk; if command -v blysk; then exit 1; fi; test ! -e /usr/share/blysk'
echo "installed, run, built upon and removed"
