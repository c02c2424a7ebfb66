#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bootstrap_test.sh SOURCE CMAKE_ARGUMENT...: the project can be configured before any Verilog has been exported; it then
# exports what would be checked in while it is built.
set -euo pipefail
source=$(readlink -f "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for entry in "$source"/{CMakeLists.txt,rtl_sysc,scripts,tb}; do ln -s "$entry" "$folder"; done
if ! cmake -S "$folder" -B "$folder/build" -G Ninja "${@:2}" >"$folder/said" 2>&1; then
  cat "$folder/said" >&2
  exit 1
fi
exports=$(ninja -C "$folder/build" -t commands sweep_verilog | grep -c ' update .*/build/rtl_verilog/') || true
variants=$(($(grep -c '^BLYSK_DEVICE(' "$source/tb/devices/devices.def") + $(cat "$source"/tb/devices/*/verilated | grep -c .)))
expected=$((variants * $(grep -c '^BLYSK_NAMED_FORMAT(' "$source/tb/formats.def")))
echo "$exports exports for $expected devices, those with options among them, and formats"
[ "$exports" = "$expected" ]
