#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# variants.sh EXPORTED VARIANTS DEVICE FORMAT...: exports the device with its options, a line of VARIANTS each, lints it, and
# has Icarus repeat a run of the SystemC device.
set -euo pipefail
exported=$1
variants=$2
device=$3
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

while read -ra options; do
  for format in "${@:4}"; do
    out=$folder/$format
    rm -rf "$out"
    "$exported" replay "$out" "$device" "$format" "${options[@]}"
    "$here/lint.sh" "$out" verilator icarus yosys
    (cd "$out/replay" && iverilog -g2001 -s replay -o replay.vvp ../*.v replay.v && vvp -n replay.vvp >said)
    if ! grep -qx '2000 cycles replayed, 0 differ' "$out/replay/said"; then
      echo "$device $format ${options[*]}: $(cat "$out/replay/said")" >&2
      exit 1
    fi
  done
done <"$variants"
