#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# narrow.sh ASSERTION COMPILER [ARGUMENT]...: the assertion, "HEADER CONDITION", holds.
# narrow.sh ASSERTION FILE NET FROM TO COMPILER [ARGUMENT]...: FROM is replaced by TO in the format of a net, in a copy of FILE.
# With one integer bit less the file must fail to compile. From the project's folder.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
refusal=$here/../../blocks/must_not_compile.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
read -r header condition <<<"$1"
shift
printf '#include "%s"\nstatic_assert(%s);\n' "$header" "$condition" >"$work/source.cpp"
[[ $1 = *.h ]] || { "$refusal" "" "$@" "$work/source.cpp"; exit; }
file=$1 net=$2 from=$3 to=$4
shift 4
compiler=$1
shift
copy=$work/copy
mkdir -p "$copy/$(dirname "$file")"
# The first FROM between "using NET =" and the statement's end.
NET=$net FROM=$from TO=$to awk '
  { text = text $0 "\n" }
  END {
    head = "using " ENVIRON["NET"] " ="
    start = index(text, head)
    if (start == 0) exit 1
    rest = substr(text, start)
    end = index(rest, ";")
    at = index(substr(rest, 1, end), ENVIRON["FROM"])
    if (at == 0) exit 1
    printf "%s%s%s%s", substr(text, 1, start - 1), substr(rest, 1, at - 1), ENVIRON["TO"],
           substr(rest, at + length(ENVIRON["FROM"]))
  }' "$file" >"$copy/$file" || { printf '%s has no net %s of a format %s\n' "$file" "$net" "$from"; exit 1; }
"$refusal" "static_assert\(fits<$net>" "$compiler" "-I$copy" "$@" "$work/source.cpp"
