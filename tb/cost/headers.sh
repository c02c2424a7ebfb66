#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# headers.sh BLYSK ROOT DEVICE: every figure at the head of each top module of rtl_verilog/ is that of the measured files, what they
# have is there, and the digest is that of the modules without the comment. Then one worst error or bias of a q8 device is
# computed again; BLYSK_SEED chooses which. At last
# each fault in a copy of the q8 of DEVICE has to be noticed.
set -euo pipefail
unset CDPATH
blysk=$(readlink -f "$1") root=$(readlink -f "$2")
export LC_ALL=C
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
first='// What blysk knows of it'
figures=0

# value FILE KEY: of a stored JSON file.
value() { sed -nE "s/^  \"$2\": \"?([^\"]*[^\",])\"?,?\$/\1/p" "$1"; }
# part FILE NAME: a part of a row of cost, two blanks deep.
part() { sed -n "/^  \"$2\": {\$/,/^  }/p" "$1"; }
# of_part FILE NAME KEY
of_part() { sed -nE "s/^ *\"$3\": \"?([^\"]*[^\",])\"?,?\$/\1/p" <<<"$(part "$1" "$2")" | sed -n 1p; }

wrong() { echo "$top: $*" && bad=$((bad + 1)); }

# line KEY: what the header says there.
line() { sed -n "s|^//   $1: ||p" <<<"$header"; }

# expect WHAT SAID WANTED: two figures or texts are the same.
expect() {
  figures=$((figures + 1))
  awk -v said="$2" -v wanted="$3" 'BEGIN {
    if (said ~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/ && wanted ~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/) exit !(said + 0 == wanted + 0)
    exit !(said == wanted && said != "")
  }' || wrong "$1 is '$2', the measured file has '$3'"
}

# numbers TEXT PATTERN: its groups, a blank between them.
numbers() { sed -nE "s/$2/\1 \2 \3 \4 \5/p" <<<"$1"; }

# tools_of FILE PART: as the header names them.
tools_of() {
  part "$1" "$2" | sed -nE '/^    "tools": \{/,/^    \}/s/^ {6}"(sta|yosys|nextpnr-ice40)": "(.*)",?$/\1 \2/p' |
    sed -E 's/^sta /OpenSTA /; s/^(yosys|nextpnr-ice40) //' | awk '{ printf "%s%s", NR == 1 ? "" : ", ", $0 }'
}

check_cells() { # FILE PART NAME
  local said got
  said=$(line "$3")
  if [ -z "$(part "$1" "$2")" ]; then
    { [ -z "$said" ] && grep -qE "^//   not known[^:]*:.* $3(,|\$)" <<<"$header"; } ||
      wrong "says nothing of $3, or something that was not measured"
    return 0
  fi
  expect "digest of $3" "$digest" "$(of_part "$1" "$2" digest)"
  case $2 in
    hx8k)
      read -r -a got <<<"$(numbers "$said" '^([0-9.]+) MHz, the least of ([0-9]+) seeds; .*()()()')"
      expect "$3" "${got[0]-}" "$(part "$1" hx8k | sed -n '/"fmax_mhz"/,/\]/p' | sed -nE 's/^ +([0-9.]+),?$/\1/p' | sort -g | sed -n 1p)"
      expect "$3, seeds" "${got[1]-}" "$(part "$1" hx8k | sed -n '/"seeds"/,/\]/p' | grep -cE '^ +[0-9]+,?$')"
      ;;
    osu018)
      read -r -a got <<<"$(numbers "$said" '^([0-9.]+) NAND2, ([0-9]+) cells, longest path ([0-9.]+) ns; .*()()')"
      expect "$3, area" "${got[0]-}" "$(of_part "$1" "$2" area_nand2)"
      expect "$3, cells" "${got[1]-}" "$(of_part "$1" "$2" cells)"
      expect "$3, path" "${got[2]-}" "$(of_part "$1" "$2" path_ns)"
      ;;
    *)
      read -r -a got <<<"$(numbers "$said" '^([0-9]+) LUT, ([0-9]+) carry, ([0-9]+) FF, ([0-9]+) DSP, ([0-9]+) RAM bits; .*')"
      expect "$3, LUT" "${got[0]-}" "$(of_part "$1" "$2" lut)"
      expect "$3, carry" "${got[1]-}" "$(of_part "$1" "$2" carry)"
      expect "$3, FF" "${got[2]-}" "$(of_part "$1" "$2" ff)"
      expect "$3, DSP" "${got[3]-}" "$(of_part "$1" "$2" dsp)"
      expect "$3, RAM" "${got[4]-}" "$(of_part "$1" "$2" ram_bits)"
      ;;
  esac
  expect "tools of $3" "${said#*; }" "$(tools_of "$1" "$2")"
}

check_errors() { # FILE DOMAIN WORDS
  local said got section
  said=$(sed -n "s/^\/\/   error against c^n, $3: //p" <<<"$header")
  section=$(sed -n "/^    \"$2\": {\$/,/^    }/p" "$1")
  of_section() { sed -nE "s/^ *\"$1\": \"?([^\"]*[^\",])\"?,?\$/\1/p" <<<"$section"; }
  read -r -a got <<<"$(numbers "$said" '^at most ([^ ]+) \(n = ([0-9]+), c = ([^ )]+)\), bias ([^ ;]+); ([0-9]+) inputs, n in 1\.\.1000, .*')"
  expect "worst error, $2" "${got[0]-}" "$(of_section max_abs_err)"
  expect "its n, $2" "${got[1]-}" "$(of_section max_abs_n)"
  expect "its c, $2" "${got[2]-}" "$(of_section max_abs_cos)"
  expect "bias, $2" "${got[3]-}" "$(of_section bias)"
  expect "inputs, $2" "${got[4]-}" "$(of_section points)"
  expect "status, $2" "${said##*, }" "$(of_section status)"
}

check_certificate() { # FILE [OTHER]
  local said got digest=$digest
  said=$(line certificate)
  if [ -n "${2:-}" ]; then
    expect 'device of the certificate' "${said%%: *}" "that of $2, whose BRDF it computes"
    said=${said#*: }
    digest=$(sed -n 's/^\/\/   digest: //p' "$root/rtl_verilog/${2//-/_}_$format/blysk_${2//-/_}_$format.v")
  fi
  read -r -a got <<<"$(numbers "$said" '^BRDF within ([^ ]+) of what it computes in real numbers, proved by Gappa ([^;]+); at most ([^ ]+) seen, ([0-9]+) inputs, (.*)')"
  expect certificate "${got[0]-}" "$(value "$1" bound)"
  expect 'version of Gappa' "${got[1]-}" "$(value "$1" gappa)"
  expect 'error seen' "${got[2]-}" "$(seen "$1" max_abs_err)"
  expect 'inputs of the error seen' "${got[3]-}" "$(seen "$1" inputs)"
  expect 'status of the error seen' "${got[4]-}" "$(seen "$1" status)"
  expect 'digest of the certificate' "$digest" "$(value "$1" digest)"
}
seen() { sed -nE "s/^    \"$2\": \"?([^\"]*[^\",])\"?,?\$/\1/p" "$1"; }

# check FOLDER: the top module there.
check() {
  local folder=$1 name device other format file cost got said bad=0
  name=${folder##*/} top=blysk_${folder##*/}
  format=q${name##*_q} device=${name%_q*}
  header=$(sed -n "/^${first//\//\\/}/,/^\`default_nettype/p" "$folder/$top.v")
  [ -n "$header" ] || { wrong "has no comment of what was measured" && return 1; }
  [ -n "$(line computes)" ] || wrong "does not say what it computes"
  digest=$(line digest)
  expect digest "$digest" "sha256:$(for file in "$folder"/*.v; do
    printf '%s\n' "${file##*/}"
    sed "/^${first//\//\\/}/,/^\`default_nettype/{/^\/\//d}" "$file"
    printf '\0'
  done | sha256sum | cut -d ' ' -f 1)"

  # Errors: those of the device whose results these are.
  other=$(sed -nE 's/^set\(computes_as ([a-z-]+)\).*/\1/p' "$root/tb/devices/$device/tests.cmake" 2>/dev/null) || other=''
  file=$root/docs/tables/${other:-$device}/errors_$format.json
  file=${file//-/_}
  if [ -f "$file" ]; then
    check_errors "$file" whole 'every code of the cosine'
    check_errors "$file" sphere 'pixels of a lit sphere, 512 x 512'
  else
    { grep -qE '^//   not known[^:]*:.* errors' <<<"$header" && ! grep -q '^//   error' <<<"$header"; } ||
      wrong 'says nothing of errors, or of some that were not measured'
  fi
  cost=$root/docs/tables/$device/cost_$format.json
  [ -f "$cost" ] || cost=/dev/null
  check_cells "$cost" ice40 iCE40
  check_cells "$cost" ice40_dsp 'iCE40 with DSP'
  check_cells "$cost" hx8k 'iCE40 HX8K'
  check_cells "$cost" osu018 OSU018
  file=${other:-$device}
  file=$root/docs/tables/${file//-/_}/certificate_$format.json said=$(line certificate)
  if [ -f "$file" ]; then
    check_certificate "$file" "$other"
  else
    { [ -z "$said" ] && grep -qE '^//   not known[^:]*:.* certificate' <<<"$header"; } ||
      wrong 'says nothing of a certificate, or of one that is not there'
  fi

  file=$root/docs/tables/$device/delays_$format.json said=$(line settles)
  if [ -f "$file" ]; then
    expect 'digest of the delays' "$digest" "$(value "$file" digest)"
    read -r -a got <<<"$(numbers "$said" '^within ([0-9.]+) ns in OSU018 with its blocks apart(, ([0-9.]+) ns seen in ([0-9]+) pairs of writes)?; .*()')"
    expect 'settles' "${got[0]-}" "$(awk -v ps="$(value "$file" bound_ps)" 'BEGIN { print ps / 1000 }')"
    got=("$(sed -nE 's/.*, ([0-9.]+) ns seen in ([0-9]+) pairs.*/\1,\2/p' <<<"$said")")
    expect 'settles, seen' "${got[0]}" \
      "$(awk -F , -v device="${device//_/-}" -v format="$format" '$1 == device && $2 == format { print $3 "," $7 }' "$root/docs/tables/settling.csv")"
    # The constraint holds for both ways to map: blocks apart, and the device as a whole.
    got=0
    [ "$cost" = /dev/null ] || got=$(of_part "$cost" osu018 path_ns)
    expect 'set_max_delay' "$(sed -nE 's/^# set_max_delay ([0-9.]+) .*/\1/p' "$folder/$top.sdc")" \
      "$(awk -v bound="$(value "$file" bound_ps)" -v path="$got" 'BEGIN {
        cents = 100 * path
        print (path > bound / 1000 ? (int(cents) + (int(cents) < cents)) / 100 : bound / 1000)
      }')"
  else
    { [ -z "$said" ] && grep -qE '^//   not known[^:]*:.* settling' <<<"$header"; } ||
      wrong 'says nothing of settling, or of what was not measured'
  fi
  [ $bad = 0 ]
}

headers=0 failed=0
for folder in "$root"/rtl_verilog/*; do
  check "$folder" || failed=1
  headers=$((headers + 1))
done
echo "$headers headers, $figures figures"
[ $failed = 0 ] && [ $headers -gt 0 ] && [ $figures -gt $headers ] || exit 1

# One of them again.
mapfile -t candidates < <(cd "$root/docs/tables" && ls -d -- */errors_q8.json)
RANDOM=${seed:=${BLYSK_SEED:-$((RANDOM + 1))}}
chosen=${candidates[RANDOM % ${#candidates[@]}]}
device=${chosen%%/*}
keys=(max_abs_err bias)
key=${keys[RANDOM % 2]}
domains=(whole sphere)
domain=${domains[RANDOM % 2]}
top=blysk_${device}_q8
words='every code of the cosine'
[ "$domain" = whole ] || words='pixels of a lit sphere, 512 x 512'
said=$(sed -n "s/^\/\/   error against c^n, $words: //p" "$root/rtl_verilog/${device}_q8/$top.v")
if [ "$key" = bias ]; then said=$(sed -E 's/.*, bias ([^ ;]+);.*/\1/' <<<"$said"); else said=$(sed -E 's/^at most ([^ ]+) .*/\1/' <<<"$said"); fi
"$blysk" explore --measure --device "${device//_/-}" --format q8 --domain "$domain" --json >"$work/again.json"
again=$(sed -nE "s/^ *\"$key\": ([^,]*),?\$/\1/p" "$work/again.json" | sed -n 1p)
echo "seed $seed: $key of $device q8 on domain $domain is $said, computed again $again"
awk -v said="$said" -v again="$again" 'BEGIN {
  difference = said - again
  if (difference < 0) difference = -difference
  size = again < 0 ? -again : again
  exit !(said != "" && again != "" && difference <= 1e-5 * size)
}' || { echo "$top: $key is $said, computed again it is $again"; exit 1; }

# A spoilt figure of each kind is noticed.
spoilt=$work/${3//-/_}_q8
noticed() { # SED ENDING
  local file=blysk_${spoilt##*/}.$2
  rm -rf "$spoilt"
  cp -r "$root/rtl_verilog/${spoilt##*/}" "$spoilt"
  sed -i -E "$1" "$spoilt/$file"
  ! cmp -s "$spoilt/$file" "$root/rtl_verilog/${spoilt##*/}/$file" || { echo "the fault '$1' changes nothing"; exit 1; }
  ! check "$spoilt" >"$work/said" || { echo "the fault '$1' was not noticed"; exit 1; }
}
noticed 's/^(\/\/   error .*: at most )0\.2/\10.3/' v
noticed 's/bias -/bias /' v
noticed 's/^(\/\/   iCE40: )/\11/' v
noticed 's/^(\/\/   certificate: .*BRDF within )/\11/' v
noticed 's/([0-9.]+ NAND2,)/1\1/' v
noticed 's/^(\/\/   settles: within )/\11/' v
noticed 's/^(\/\/   OSU018:).*//' v
noticed 's/^(# set_max_delay )/\11/' sdc
noticed 's/(RAW\([0-9]+.d)1/\12/' v
