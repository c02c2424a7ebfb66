#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# uncovered.sh FILE.dat: how many of Verilator's coverage points were reached, and the others, "instance signal".
set -euo pipefail
points=$(grep -ac '^C ' "$1")
missed=$(grep -ac '^C .* 0$' "$1") || true
echo "$((points - missed)) of $points points reached"
{ grep -a '^C .* 0$' "$1" || true; } | tr '\001\002' ' =' | sed -E "s/.* o=([^ ]*) .*h=TOP\.([^ ]*)' 0/\2 \1/" | LC_ALL=C sort
