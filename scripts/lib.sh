# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# What the scripts share. Sourced, not run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# Messages go to standard error; standard output is for results.
say() { printf 'blysk %s: %s\n' "${0##*/}" "$*" >&2; }
die() { say "$@"; exit 1; }

# logged NAME COMMAND...: runs COMMAND with its output in build/logs/NAME.log. On a terminal
# its newest line is shown; when it fails, the log's tail is.
logged() {
  local log=build/logs/$1.log status=0
  shift
  mkdir -p "$root/build/logs"
  if [ -t 2 ]; then
    "$@" 2>&1 </dev/null | tee "$root/$log" | show_newest_line || status=$?
  else
    "$@" >"$root/$log" 2>&1 </dev/null || status=$?
  fi
  [ "$status" = 0 ] && return
  tail -n 30 "$root/$log" | sed 's/^/  | /' >&2
  say "that failed; the whole log is in $log"
  return 1
}

show_newest_line() {
  local line
  while IFS= read -r line; do printf '\r\033[K  %.75s' "$line" >&2; done
  printf '\r\033[K' >&2
}

wants_help() { [ "${1:-}" = --help ] || [ "${1:-}" = -h ]; }

# build [TARGET...]: configures build/ where that was not done yet, and builds the targets, or all.
build() {
  if [ ! -f "$root/build/build.ninja" ]; then
    say "configuring build/"
    logged configure cmake -S "$root" --preset release || exit 1
  fi
  say "building"
  logged build cmake --build "$root/build" ${1:+--target "$@"} || exit 1
}

# fit_layout FILE.vcd FILE.gtkw: the layout with the bus widths of the waveform, and with its fraction bits where it
# scales by those of q16.
fit_layout() {
  awk '
    NR == FNR && $1 == "$scope" && $3 != "SystemC" { scope = $3 "." }
    NR == FNR && $1 == "$upscope" { scope = "" }
    NR == FNR && $1 == "$var" && $6 ~ /^\[/ { range["SystemC." scope $5] = $6 }
    NR == FNR { next }
    FNR == 1 { split(substr(range["SystemC.cos18"], 2), bits, ":") }
    /^\[fpshift_count\]/ && bits[1] { print $1, bits[1]; next }
    match($0, /\[[0-9]+:0\]$/) {  # "SystemC.net[7:0]" or "+{alias} SystemC.net[7:0]"
      start = index($0, "SystemC.")
      name = substr($0, start, RSTART - start)
      if (name in range) $0 = substr($0, 1, RSTART - 1) range[name]
    }
    { print }' "$1" "$2"
}
