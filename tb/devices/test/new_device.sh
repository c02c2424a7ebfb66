#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# new_device.sh ROOT SYSTEMC: carries out the steps of docs/new-device.md on a copy of the tree at ROOT, with the toy device
# of tb/devices/test/new: its two folders, the line of the page, the page's commands, and the quick tests of the device.
# SYSTEMC is the folder of an installed SystemC.
set -euo pipefail
root=$(readlink -f "$1")
SYSTEMC_HOME=$(readlink -f "$2")
export SYSTEMC_HOME
unset SystemCLanguage_DIR
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
fail() { echo "$*" >&2 && exit 1; }

# What git knows of the tree, and what is new in it.
(cd "$root" && git ls-files -z --cached --others --exclude-standard | tar --null --files-from=- --ignore-failed-read -cf -) |
  tar -xf - -C "$copy"
cd "$copy"
before=$(find . -type f | sort)

# Steps 1 and 2: the folders.
mkdir -p rtl_sysc/devices tb/devices
cp -r tb/devices/test/new/rtl_sysc rtl_sysc/devices/linear
cp -r tb/devices/test/new/tb tb/devices/linear
# Step 3: the line.
page=docs/new-device.md
line=$(sed -n 's/^    \(BLYSK_DEVICE(.*)\)$/\1/p' "$page")
[ -n "$line" ] || fail "$page shows no line of devices.def"
echo "$line" >>tb/devices/devices.def
outside=$(comm -13 <(echo "$before") <(find . -type f | sort) | grep -vE '^\./(rtl_sysc|tb)/devices/linear/') || true
[ -z "$outside" ] || fail "files outside the device's folders: $outside"

# Steps 4 and 5: the page's commands, one by one.
count=0
while IFS= read -r command; do
  count=$((count + 1))
  echo "+ $command"
  bash -e -o pipefail -c "$command" >said 2>&1 || { tail -n 40 said && fail "failed: $command"; }
done < <(sed -n '/^## 4/,$s/^    //p' "$page" | sed "s/^ctest .*/& -L quick -E 'cosim|verilog|waves|docs' --no-tests=error/")
[ "$count" -ge 8 ] || fail "$page has $count commands, expected 8"
cmp linear.csv linear-systemc.csv
cmp linear.csv linear-verilog.csv
# 1 - 10 (1 - c) at c = 0.99, the first row of the example.
awk -F, 'NR > 1 { want = 1 - $1 * (1 - $2); if (want < 0) want = 0; d = $6 - want; if (d < 0) d = -d; if (d > 1 / 4096) bad = 1 }
         END { exit bad || NR < 3 }' linear.csv || fail "linear.csv is not the formula"
ls linear-rtl/*.v >/dev/null
