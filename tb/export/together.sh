#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# together.sh VERILOG_FOLDER...: one design that holds all these exports, <device>_<format> each, is read without a word.
set -euo pipefail
lint=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lint.sh
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

joined() { (IFS=, && echo "$*"); }
ports=()
instances=()
for export in "$@"; do
  format=$(basename "$export")
  top=blysk_$format
  cp "$export"/*.v "$folder"
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
