# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# What the scripts share. Sourced, not run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# Messages go to standard error; standard output is for results.
say() { printf 'blysk %s: %s\n' "${0##*/}" "$*" >&2; }
die() { say "$@"; exit 1; }

# as_owner ARGUMENT...: under sudo, starts the script again as the user who called it. Only installing packages is
# root's work; the tree and what is made in it stay its owner's.
as_owner() {
  [ "$EUID" = 0 ] && [ "${SUDO_UID:-0}" != 0 ] || return 0
  exec sudo -H -u "#$SUDO_UID" -- "$(readlink -f "$0")" "$@"
}

# logged NAME COMMAND...: runs COMMAND with its output in build/logs/NAME.log. On a terminal
# its newest line is shown; when it fails, the log's tail is.
logged() {
  local log=build/logs/$1.log status=0
  shift
  # A log that another user left is not this run's: out of the way with it, or it would be shown as such.
  if ! mkdir -p "$root/build/logs" || ! rm -f "$root/$log" || ! : >"$root/$log"; then
    die "cannot write $log; an earlier call, as root, may have made build/"
  fi
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

configure() {
  local configured=$root/build/systemc-of-environment
  say "configuring build/"
  rm -f "$configured"
  logged configure cmake -S "$root" --preset release -U SystemCLanguage_DIR -U SYSTEMC_HOME || exit 1
  echo "$systemc_of_environment" >"$configured"
}
systemc_of_environment="SystemCLanguage_DIR=${SystemCLanguage_DIR:-} SYSTEMC_HOME=${SYSTEMC_HOME:-}"

# build [TARGET...]: builds the targets, or all. Configures build/ first where that was not done yet, was done with
# another SystemC than the environment names now, or where files that it knew are gone since.
build() {
  if [ ! -f "$root/build/build.ninja" ] ||
    [ "$(cat "$root/build/systemc-of-environment" 2>/dev/null)" != "$systemc_of_environment" ] ||
    ! ninja -C "$root/build" -n build.ninja >/dev/null 2>&1; then
    configure
  fi
  say "building"
  logged build cmake --build "$root/build" ${1:+--target "$@"} || exit 1
}

# fit_layout FILE.vcd FILE.gtkw: the layout, made for q16 clamped, with the bus widths of the waveform, and with its
# fraction bits. A net keeps its integer bits from format to format, so its fraction bits grow with its width; those of
# the BRDF and the colours, which have more integer bits in a device as published, are those of cos18.
fit_layout() {
  awk '
    NR == FNR && $1 == "$scope" && $3 != "SystemC" { scope = $3 "." }
    NR == FNR && $1 == "$upscope" { scope = "" }
    NR == FNR && $1 == "$var" && $6 ~ /^\[/ { split(substr($6, 2), ends, ":"); left["SystemC." scope $5] = ends[1] }
    NR == FNR { next }
    $1 == "[fpshift_count]" { shift_count = $2; next }
    match($0, /\[[0-9]+:0\]$/) {  # "SystemC.net[7:0]" or "+{alias} SystemC.net[7:0]"
      start = index($0, "SystemC.")
      name = substr($0, start, RSTART - start)
      was = substr($0, RSTART + 1) + 0
      is = name in left ? left[name] : was
      if (name ~ /quant11|out2[567]/) is_shift = left["SystemC.cos18"]
      else is_shift = shift_count + is - was
      $0 = substr($0, 1, RSTART) is ":0]"
      if (shift_count != "") print "[fpshift_count] " is_shift
      shift_count = ""
    }
    { print }' "$1" "$2"
}
