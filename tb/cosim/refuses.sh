#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# refuses.sh PROGRAM ARGUMENT...: bad use of the program is answered with one line that says what was expected, on standard
# error, and status 2.
set -uo pipefail
said=$("$@" 2>&1 >/dev/null)
status=$?
printf '%s\nstatus %s\n' "$said" "$status"
[ "$status" = 2 ] && [ "$(wc -l <<<"$said")" = 1 ] && [[ $said =~ ^blysk:\ .*expected\ .+ ]]
