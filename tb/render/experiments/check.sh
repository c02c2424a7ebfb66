#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# check.sh THESIS_PICTURES TABLES: makes the tables elsewhere and fails if one differs from that in TABLES.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" "$work"
for made in "$work"/*; do
  diff "$2/${made##*/}" "$made" || { echo "${made##*/} is stale: the target update_thesis_pictures writes it" >&2 && exit 1; }
done
