#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# variants.sh BLYSK: exports devices that rtl_verilog/ does not hold, every option but the default, and lints them.
set -euo pipefail
blysk=$1
lint=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lint.sh
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

for options in '--coefficient published' --as-published '--coefficient published --as-published' '--constant 101'; do
  for format in q{8..24..2}; do
    out="$folder/$format ${options// /}"
    # shellcheck disable=SC2086  # several words
    "$blysk" export --device quadratic --format "$format" $options --output "$out" >/dev/null
    "$lint" "$out" verilator icarus yosys
  done
done
