#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# together.sh RTL_VERILOG DEVICE FORMAT...: one design that holds the device in these formats is read without a word.
set -euo pipefail
rtl=$(readlink -f "$1")
device=$2
lint=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lint.sh
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

joined() { (IFS=, && echo "$*"); }
ports=()
instances=()
for format in "${@:3}"; do
  top=blysk_${device}_$format
  cp "$rtl/${device}_$format"/*.v "$folder"
  connections=()
  while read -r port; do # "input  wire [7:0] r_i"
    ports+=("${port}_$format")
    connections+=(".${port##* }(${port##* }_$format)")
  done < <(sed -nE 's/,? *(\/\/.*)?$//; s/^ +((in|out)put .*)/\1/p' "$folder/$top.v")
  instances+=("$top $format ($(joined "${connections[@]}"));")
done
{
  echo "module together ($(joined "${ports[@]}"));"
  printf '  %s\n' "${instances[@]}"
  echo endmodule
} >"$folder/together.v"
(cd "$folder" && printf '%s\n' *.v >together.f)
"$lint" "$folder" verilator icarus yosys
