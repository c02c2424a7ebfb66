#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# colours_test.sh ROOT BLYSK: pictures and page of the measured rows have a colour for each device with an error, each another
# one, and both have the same.
set -euo pipefail
unset CDPATH
root=$1
devices=$("$2" explore --measured "$root/docs/tables" --csv | awk -F, '
  NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
  $at["status"] != "" { print $at["device"] }' | sort -u | wc -l)
colours() { grep -oE '#[0-9a-f]{6}\b'; }
picture=$(sed -n '/^palette =/,/^colour(/p' "$root/tb/cost/front.gnuplot" | colours)
page=$(sed -n '/^const colours =/,/;$/p' "$root/tb/cost/front.html" | colours)
if [ "$picture" != "$page" ]; then
  diff <(echo "$picture") <(echo "$page") >&2 || true
  echo "front.gnuplot and front.html have other colours" >&2
  exit 1
fi
twice=$(sort <<<"$page" | uniq -d)
if [ -n "$twice" ]; then
  echo "a colour is there twice: $twice" >&2
  exit 1
fi
count=$(wc -l <<<"$page")
if [ "$devices" = 0 ] || [ "$count" -lt "$devices" ]; then
  echo "$count colours for $devices devices with an error" >&2
  exit 1
fi
