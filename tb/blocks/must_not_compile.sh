#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# must_not_compile.sh REASON COMPILER [ARGUMENT]...: the compiler refuses its arguments by a message that matches REASON, an
# extended regular expression; if REASON is empty, it accepts them.
set -euo pipefail
export LC_ALL=C  # the message in English
reason=$1
shift
if message=$("$@" 2>&1); then
  [ -z "$reason" ] && exit 0
  printf 'compiles, expected a refusal: %s\n' "$reason"
  exit 1
fi
printf '%s\n' "$message"
if [ -z "$reason" ] || ! grep -qE -- "$reason" <<<"$message"; then
  printf 'is refused, expected %s\n' "${reason:+the reason: }${reason:-no refusal}"
  exit 1
fi
