#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# what_a_device_adds.sh BUILD: CSV of the time that each device took there, from the logs of ninja and CTest: seconds of its own
# build steps and seconds of its tests, and how many of both. They are wall-clock seconds. On two cores ninja runs three steps
# at a time and scripts/test two tests: a third of build_s and half of test_s is what the device adds to the wait. The objects
# with the netlists of all devices are a row of their own, "netlists", and what belongs to no device is "rest". It takes a new
# build folder and one run of scripts/test: in a second run CTest loses the times of tests with a blank in their name.
set -euo pipefail
build=${1:?usage: what_a_device_adds.sh BUILD}
for file in "$build/.ninja_log" "$build/Testing/Temporary/CTestCostData.txt" "$build/bin/blysk"; do
  [ -f "$file" ] || { echo "what_a_device_adds.sh: $file is not there; run scripts/test first" >&2; exit 2; }
done
export LC_ALL=C
devices=$("$build/bin/blysk" list --json | sed -nE '/^  "devices"/,/^  \]/s/^      "name": "([a-z-]+)",?$/\1/p')
[ -n "$devices" ] || { echo "what_a_device_adds.sh: blysk list --json names no device" >&2; exit 1; }

awk -v devices="$devices" '
  # The longest name of a device that stands in the text as a word.
  function device_in(text,   i, best) {
    gsub(/-/, "_", text)
    best = ""
    for (i in word)
      if (length(word[i]) > length(best) && text ~ ("(^|[^a-z])" word[i] "([^a-z]|$)")) best = word[i]
    return best
  }
  BEGIN {
    count = split(devices, name, "\n")
    for (i = 1; i <= count; i++) { word[i] = name[i]; gsub(/-/, "_", word[i]) }
  }
  FILENAME ~ /ninja_log$/ {
    # Start, end in milliseconds, time of the file, its name, digest of the command. A step that makes several files stands
    # there once for each.
    if ($1 ~ /^#/ || split($0, field, "\t") < 5) next
    step = field[1] " " field[2] " " field[5]
    if (step in seen) next
    seen[step] = 1
    owner = field[4] ~ /per_format/ ? "netlists" : field[4] ~ /^(tb\/(cosim|devices)|rtl_verilog|tests)\// ? device_in(field[4]) : ""
    if (owner == "") owner = "rest"
    steps[owner]++
    built[owner] += (field[2] - field[1]) / 1000
    next
  }
  /^---/ { nextfile }
  {
    # Name, runs, mean seconds. A name may have blanks.
    seconds = $NF
    test = $0
    sub(/ [0-9]+ [0-9.e+-]+$/, "", test)
    owner = device_in(test)
    if (owner == "") owner = "rest"
    tests[owner]++
    tested[owner] += seconds
  }
  END {
    print "device,build_steps,build_s,tests,test_s"
    name[++count] = "netlists"; word[count] = "netlists"
    name[++count] = "rest"; word[count] = "rest"
    for (i = 1; i <= count; i++)
      printf "%s,%d,%.0f,%d,%.0f\n", name[i], steps[word[i]], built[word[i]], tests[word[i]], tested[word[i]]
  }
' "$build/.ninja_log" "$build/Testing/Temporary/CTestCostData.txt"
