# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# What the scripts share. Sourced, not run.

# With CDPATH, cd prints where it went; the order of a sort, numbers and messages depend on the locale.
unset CDPATH
export LC_ALL=C.UTF-8
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)

# Messages go to standard error, one line each; standard output is for results.
say() {
  local text="$*"
  iconv -f UTF-8 -t UTF-8 <<<"$text" >/dev/null 2>&1 || text=$(LC_ALL=C && printf %q "$text")
  text=${text//[[:cntrl:]$'\u202A'-$'\u202E'$'\u2066'-$'\u2069']/?}
  printf 'blysk %s: %s\n' "${0##*/}" "$text" >&2
}
die() { say "$@"; exit 1; }

# bad_input WHAT: of a file that a user named.
bad_input() { say "$@"; exit 2; }

# make_folder FOLDER: with those above it.
make_folder() { mkdir -p -- "$1" 2>/dev/null || bad_input "cannot make the folder '$1', expected one to write into"; }

# take_help "$@": where --help or -h is among the script's arguments, shows its help() and ends it.
take_help() {
  local word
  for word; do
    case $word in
      --) return ;;
      --help | -h) help && exit ;;
    esac
  done
}

# refuse WHAT...: ends a script that was called wrongly.
refuse() { say "$*; see scripts/${0##*/} --help"; exit 2; }

# expect MOST "$@": refuses options and what is more than MOST arguments.
expect() {
  local most=$1 word
  shift
  for word; do [[ $word != -* ]] || refuse "'$word' is unknown"; done
  [ $# -le "$most" ] || refuse "'${*:most + 1:1}' is one argument too many"
}

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

configure() {
  local configured=$root/build/systemc-of-environment
  say "configuring build/"
  rm -f "$configured" 2>/dev/null || die "cannot write build/; an earlier call, as root, may have made it"
  logged configure cmake -S "$root" --preset release "$@" -U SystemCLanguage_DIR -U SYSTEMC_HOME || exit 1
  echo "$systemc_of_environment" >"$configured"
}
systemc_of_environment="SystemCLanguage_DIR=${SystemCLanguage_DIR:-} SYSTEMC_HOME=${SYSTEMC_HOME:-}"

# cached NAME: the value in build/CMakeCache.txt.
cached() { sed -n "s/^$1:[^=]*=//p" "$root/build/CMakeCache.txt"; }

# build [TARGET...]: builds the targets, or all, with all formats and engines. Configures build/ first where that was not
# done yet, was done by build_part or with another SystemC than the environment names now, or where files that it knew are
# gone since; afresh where build/ is that of another tree, of which this one is a copy, or of this one at another place.
build() {
  local whole=(-DBLYSK_FORMATS= -DBLYSK_VERILATED=ON -DBUILD_TESTING=ON -DCMAKE_UNITY_BUILD=OFF)
  if is_of_another_place; then
    say "build/ is that of another tree or place"
    configure --fresh
  elif is_part; then
    configure "${whole[@]}"
  elif must_configure; then
    configure
  fi
  build_configured "$@"
}

# build_part FORMAT TARGET...: builds the targets, with q16, FORMAT and without engine verilator where build/ is not there yet:
# minutes in place of an hour. What is there in build/ already stays in it.
build_part() {
  expect_format "$1"
  local format=$1 part=(-DBLYSK_VERILATED=OFF -DBUILD_TESTING=OFF -DCMAKE_UNITY_BUILD=ON)
  local formats=q16
  [ "$format" = q16 ] || formats+=";$format"
  shift
  if is_of_another_place; then
    say "build/ is that of another tree or place"
    configure --fresh "-DBLYSK_FORMATS=$formats" "${part[@]}"
  elif [ ! -f "$root/build/CMakeCache.txt" ]; then
    configure "-DBLYSK_FORMATS=$formats" "${part[@]}"
  elif is_part && [[ ";$(cached BLYSK_FORMATS);" != *";$format;"* ]]; then
    configure "-DBLYSK_FORMATS=$(cached BLYSK_FORMATS);$format"
  elif must_configure; then
    configure
  fi
  build_configured "$@"
}

# formats: the named formats, a line each.
formats() { sed -nE 's/^BLYSK_NAMED_FORMAT\((.+)\).*/\1/p' "$root/tb/formats.def"; }

# expect_format FORMAT: refuses a name that no format has, before anything is configured for it.
expect_format() { formats | grep -qxF -- "$1" || bad_input "format '$1' does not exist, expected $(formats | paste -sd' ')"; }

# is_part: whether build/ has some formats only.
is_part() { [ -f "$root/build/CMakeCache.txt" ] && [ -n "$(cached BLYSK_FORMATS)" ]; }

is_of_another_place() {
  [ -f "$root/build/CMakeCache.txt" ] &&
    ! { [ "$(cached CMAKE_HOME_DIRECTORY)" -ef "$root" ] && [ "$(cached CMAKE_CACHEFILE_DIR)" -ef "$root/build" ]; }
}

must_configure() {
  [ ! -f "$root/build/build.ninja" ] ||
    [ "$(cat "$root/build/systemc-of-environment" 2>/dev/null)" != "$systemc_of_environment" ] ||
    ! ninja -C "$root/build" -n build.ninja >/dev/null 2>&1
}

build_configured() {
  say "building"
  logged build cmake --build "$root/build" ${1:+--target "$@"} || exit 1
}

# wave_header FILE.vcd: what stands before the waves; of a large file only that is read.
wave_header() { sed '/\$enddefinitions/q' "$1"; }

# device_of_waves FILE.vcd: the arguments that choose the device, as `blysk simulate --vcd` leaves them; nothing for the
# waves of another program.
device_of_waves() { wave_header "$1" | sed -n 's/\r$//; s/^blysk-device \(\(--[a-z-]* *[A-Za-z0-9.,-]* *\)*\)$/\1/p' | sed -n 1p; }
