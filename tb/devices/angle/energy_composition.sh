#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# energy_composition.sh EXPORTED COMPOSITION FORMAT [FAULT]: `angle` with a factor of the lobe is what composed.v says with
# ENERGY defined. COMPOSITION is composition.sh, FAULT as it has it.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
[ $# -ge 3 ] || { sed -n '3,4s/^# //p' "${BASH_SOURCE[0]}" >&2 && exit 2; }
exported=$1 composition=$2 format=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$exported" replay "$folder/angle_$format" angle "$format" --energy exact
{ echo '`define ENERGY'; cat "$here/composed.v"; } >"$folder/composed.v"
"$composition" "$folder/angle_$format" "$folder/composed.v" "$format" "${@:4}"
