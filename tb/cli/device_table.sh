#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# device_table.sh check|update BLYSK README: the lines of README between the markers "devices" and "end of devices" are what
# BLYSK list --markdown prints, or are made so. Exit 1 if they are others.
set -euo pipefail
if [ $# != 3 ] || [[ ! $1 =~ ^(check|update)$ ]]; then
  sed -n '3,4s/^# //p' "$0" >&2
  exit 2
fi
action=$1 program=$2 page=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$program" list --markdown >"$folder/table"
awk -v table="$folder/table" '
  /^<!-- end of devices -->$/ { inside = 0; ++ends }
  !inside { print }
  /^<!-- devices: / { inside = 1; ++begins; while ((getline line <table) > 0) print line }
  END { exit !(begins == 1 && ends == 1) }' "$page" >"$folder/page" || { echo "$page: expected the two markers" >&2 && exit 2; }
case $action in
  check) diff "$page" "$folder/page" || { echo "$page is stale: the target update_device_table writes it" && exit 1; } ;;
  update) cmp -s "$page" "$folder/page" || cp "$folder/page" "$page" ;;
esac
