#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# vectors_test.sh ROOT BLYSK DEVICE CASE: `blysk check` judges hardware that is driven by the bench beside its export, and a
# model in Python.
#   icarus     the exported Verilog of q8 is equal, each of ten faults planted in it is found
#   verilator  the exported Verilog of q12 is equal under Verilator
#   python     the model in Python is equal, and with another constant is not
#   serial     the host of a serial line, with the model in Python at its other end
set -euo pipefail
root=$1 blysk=$2 device=$3 case=$4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
examples=$root/docs/examples
fail() { echo "$*" >&2 && exit 1; }
# judged STATUS FORMAT [WHAT]: what check says of answers.txt.
judged() {
  local status=0
  "$blysk" check --device "$device" --format "$2" --answers answers.txt >said 2>&1 || status=$?
  [ "$status" = "$1" ] || fail "exit $status, expected $1 ${3:-}: $(head -n 3 said)"
}
top=blysk_${device//-/_}

case $case in
  icarus)
    cp -r "$root/rtl_verilog/${device//-/_}_q8" export
    "$blysk" vectors --device "$device" --format q8 --output vectors.txt
    simulated() {
      iverilog -g2001 -s "${top}_q8_bench" -o bench "$1"/*.v "$1"/*.vt
      vvp -n bench >/dev/null
    }
    simulated export
    judged 0 q8
    grep -q 'vectors of .* equal$' said || fail "$(cat said)"
    # Answers that cannot be written are no answers of a run before.
    vvp -n bench +answers=none/answers.txt >said
    grep -q '^none/answers.txt cannot be written, expected a file for the answers' said || fail "$(cat said)"
    # Nor are those to a file that is not what it should be; comments go through, blank lines do not count.
    kept=$(<vectors.txt)
    vvp -n bench +answers=vectors.txt >said
    grep -q '^vectors.txt is the file of vectors and of answers, expected two' said || fail "$(cat said)"
    [ "$(<vectors.txt)" = "$kept" ] || fail 'the vectors are gone'
    last=$(tail -n 1 vectors.txt)
    for line in 'zzz 1' "x${last:1}" "0x${last:2}" "${last% *}" "$last 0" "fff${last:3}" "10000000000000${last}" 'junk' "$(printf '%0300d' 0)"; do
      { sed 3q vectors.txt && printf '%s\n' "$line" && sed 1,3d vectors.txt; } >wrong.txt
      vvp -n bench +vectors=wrong.txt >said
      grep -q '^wrong.txt:4: expected 5 hexadecimal numbers' said || fail "'$line': $(cat said)"
      judged 2 q8 "after '$line'"
    done
    { sed 3q vectors.txt && printf '\n' && sed 1,3d vectors.txt; } >blank.txt
    vvp -n bench +vectors=blank.txt >/dev/null
    judged 0 q8
    for length in 253 254 255 256 300 600; do
      { sed 3q vectors.txt && printf "#%0${length}d\\n" 0 && sed 1,3d vectors.txt; } >long.txt
      vvp -n bench +vectors=long.txt >/dev/null
      [ "$(wc -l <answers.txt)" = "$(wc -l <long.txt)" ] || fail "a comment of $length characters takes a vector with it"
    done
    sed 1d vectors.txt >bare.txt
    vvp -n bench +vectors=bare.txt >/dev/null
    judged 0 q8
    [ "$(wc -l <answers.txt)" = "$(wc -l <bare.txt)" ] || fail 'a vector without a header before it is lost'
    count=0
    # found FILES OLD NEW: OLD stands once in one of the export's files; with NEW in its place the check finds it.
    found() {
      local files
      rm -rf faulty
      cp -r export faulty
      # shellcheck disable=SC2086
      files=$(cd faulty && grep -lF -- "$2" $1)
      [ "$(wc -l <<<"$files")" = 1 ] && [ "$(grep -cF -- "$2" "faulty/$files")" = 1 ] || fail "'$2' is not there once"
      OLD=$2 NEW=$3 awk '{ at = index($0, ENVIRON["OLD"])
        if (at) $0 = substr($0, 1, at - 1) ENVIRON["NEW"] substr($0, at + length(ENVIRON["OLD"]))
        print }' "export/$files" >"faulty/$files"
      simulated faulty
      judged 1 q8 "with '$3' for '$2'"
      [ "$(grep -c ' ulp ' said)" -ge 1 ] || fail "no difference is shown for '$2'"
      count=$((count + 1))
    }
    found '*.v' "8'd201" "8'd200"
    found '*.v' "2'd3)) node32" "2'd1)) node32"
    found '*.v' "1'd1)) carry28" "1'd0)) carry28"
    found '*.v' '.b_i(g_ks), .p_o(g_o)' '.b_i(r_ks), .p_o(g_o)'
    found '*.v' '.a_i(brdf), .b_i(b_ks)' '.a_i(cos_delta), .b_i(b_ks)'
    found '*_quantise_*.v' "+ 34'd32768" "+ 34'd0"
    found '*_quantise_*.v' "shifted[17] ? 9'd0 :" "shifted[17] ? 9'd1 :"
    found '*_inverter_bank_*.v' '~{' '{'
    found '*_reg_trailing_*.v' 'we_q && !we_i' '!we_q && we_i'
    found '*_reg_level_uq8_0.v' 'else if (we_i)' 'else if (!we_i)'
    [ "$count" = 10 ] || fail "$count faults"
    ;;
  verilator)
    "$blysk" vectors --device "$device" --format q12 --output vectors.txt
    export=$root/rtl_verilog/${device//-/_}_q12
    verilator --binary --timing -Wno-fatal -Wno-lint --top-module "${top}_q12_bench" -Mdir made -o bench \
      "$export"/*.v "$export"/*.vt >log 2>&1 || { cat log >&2 && exit 1; }
    made/bench >/dev/null
    judged 0 q12
    for line in junk '001 x001 ff ff ff' '0x1 0001 ff ff ff'; do
      { sed 3q vectors.txt && echo "$line"; } >wrong.txt
      made/bench +vectors=wrong.txt >said
      grep -q '^wrong.txt:4: expected 5 hexadecimal numbers' said || fail "'$line': $(cat said)"
      judged 2 q12
    done
    ;;
  python)
    command -v python3 >/dev/null || exit 77
    "$blysk" vectors --device "$device" --format q8 | python3 "$examples/vectors_model.py" >answers.txt
    judged 0 q8
    sed 's/201 \* n/202 * n/' "$examples/vectors_model.py" >wrong.py
    "$blysk" vectors --device "$device" --format q8 | python3 wrong.py >answers.txt
    judged 1 q8
    ;;
  serial)
    command -v python3 >/dev/null || exit 77
    cat >board.py <<'END'
# HOST MODEL: a terminal whose far side is the board; the host reads standard input.
import os, pty, select, subprocess, sys
board, port = pty.openpty()
model = subprocess.Popen(["python3", "-u", sys.argv[2]], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
host = subprocess.Popen(["python3", sys.argv[1], os.ttyname(port)])
waiting = b""
while host.poll() is None:
    ready, _, _ = select.select([board], [], [], 0.1)
    if not ready:
        continue
    waiting += os.read(board, 256)
    while b"\n" in waiting:
        line, waiting = waiting.split(b"\n", 1)
        model.stdin.write(line + b"\n")
        model.stdin.flush()
        os.write(board, model.stdout.readline())
sys.exit(host.wait())
END
    "$blysk" vectors --device "$device" --format q8 --output all
    sed -n '1~97p' all | sed '1s/.*/# some vectors/' >vectors.txt
    timeout 100 python3 board.py "$examples/serial_host.py" "$examples/vectors_model.py" <vectors.txt >answers.txt
    [ "$(wc -l <answers.txt)" = "$(wc -l <vectors.txt)" ] || fail 'answers are missing'
    judged 0 q8
    ;;
  *) fail "no case $case" ;;
esac
