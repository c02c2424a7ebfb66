#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# programs_test.sh PROGRAM...: each has help, says what is wrong with its arguments in one line and exits with status 2,
# also where standard output or error is full or closed.
set -euo pipefail
fail() { echo "$*" >&2 && exit 1; }
expect() {  # expect STATUS COMMAND...
  local status=0
  "${@:2}" || status=$?
  [ "$status" = "$1" ] || fail "exit $status, expected $1: ${*:2}"
}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for program; do
  expect 0 "$program" --help >said
  [ -s said ] || fail "$program --help says nothing"
  expect 2 "$program" --no-such-option >said 2>error
  [ "$(wc -l <error)" = 1 ] || fail "$program --no-such-option: $(cat error)"
  expect 2 "$program" --no-such-option >said 2>/dev/full
  expect 2 "$program" --no-such-option >said 2>&-
  expect 2 "$program" --help >/dev/full 2>error
  expect 2 "$program" --help >&- 2>error
done
[ "$(ls)" = 'error
said' ] || fail "left: $(ls)"
