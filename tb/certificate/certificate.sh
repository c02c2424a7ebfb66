#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# certificate.sh prove|update|FAULT CERTIFY ROOT EXACT --device D --format F [OPTIONS]: proves with Gappa the bound that
# docs/tables has for the device in the format, with what the file EXACT says; finds and writes it; or plants FAULT in the netlist,
# and the proof has to fail. Exit 77 where Gappa is missing.
set -euo pipefail
unset CDPATH
action=$1 certify=$2 root=$3 exact=$4
shift 4
chosen=("$@")
export LC_ALL=C
command -v gappa >/dev/null || { echo 'gappa is not there: scripts/setup installs it'; exit 77; }
row=$root/docs/tables/$("$certify" place "${chosen[@]}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# told SCRIPT: what Gappa says of it is in $work/said. A rewriting rule that it cannot show is a fault of the certificate:
# it would be believed. Rules and splits that a case does not need are none, nor divisors, of which rules say { WHAT <> 0 }.
told() {
  local status=0
  gappa "$1" >"$work/said" 2>&1 || status=$?
  if grep '^Warning' "$work/said" | grep -vE 'no need for the rewriting|renaming identifier|case split on|has been assumed to be nonzero when checking|maximum number of iterations reached' >"$work/bad"; then
    cat "$work/bad"
    echo "gappa does not take ${1##*/}"
    exit 1
  fi
  # What it cannot prove is told so; anything else is no answer.
  if [ $status != 0 ] && ! grep -qE 'some properties were not satisfied|no contradiction was found' "$work/said"; then
    sed -n 1,3p "$work/said"
    echo "gappa fails on ${1##*/}"
    exit 1
  fi
  return $status
}

# prove BOUND [FAULT]: of all scripts; prints those that fail. With a fault the first one is enough.
prove() {
  local script failures=0
  rm -rf "$work/scripts"
  mkdir "$work/scripts"
  "$certify" scripts "$work/scripts" "${chosen[@]}" --exact "$exact" --bound "$1" --fault "${2:-none}" || exit 1
  for script in "$work"/scripts/*.g; do
    told "$script" || { echo "not proved: ${script##*/}" && sed -n '1,3p' "$work/said" && failures=$((failures + 1)); }
    [ "$failures" = 0 ] || [ -z "${2:-}" ] || break
  done
  proved=$(find "$work/scripts" -name "*.g" | wc -l)
  [ "$failures" = 0 ]
}

bound_of() { sed -nE 's/^  "bound": ([^,]*),?$/\1/p' "$row"; }

[ "$action" = update ] || [ -f "$row" ] || { echo "$row is missing: the target update_certificates writes it"; exit 1; }
case $action in
  prove)
    prove "$(bound_of)" || exit 1
    echo "${chosen[*]}: |BRDF - formula| <= $(bound_of), $proved scripts proved"
    ;;
  update)
    mkdir "$work/asked"
    "$certify" scripts "$work/asked" "${chosen[@]}" --exact "$exact"
    for script in "$work"/asked/case_*.g; do
      told "$script" || true
      # "x in [-1b-9 {-0.00195312, -2^(-9)}, 33b-66 {0.0045, ...}]"; a case that cannot be has no result.
      sed -nE 's/^ .* in \[(.*)\]$/\1/p' "$work/said" | sed -E 's/\{([^,}]*)[^}]*\}/\1/g; s/, /\n/g' | awk '{ print ($NF < 0 ? -$NF : $NF) }'
    done | sort -g | tail -n 1 >"$work/largest"
    # Six digits, and a little more than the digits that Gappa prints.
    bound=$(awk '{ printf "%.6g", $1 * 1.00001 }' "$work/largest")
    prove "$bound" || exit 1
    mkdir -p "${row%/*}"
    "$certify" row "$row" "${chosen[@]}" --bound "$bound" --gappa "$(gappa --version 2>&1 | sed -n 's/^Gappa //p')"
    echo "${chosen[*]}: |BRDF - formula| <= $bound, $proved scripts proved"
    ;;
  *)
    ! prove "$(bound_of)" "$action" || { echo "the proof holds in spite of the fault $action"; exit 1; }
    ;;
esac
