#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# layout.sh LAYOUT_SHOWS DIRECTORY icarus|verilator: each row of the layout beside an export shows a signal of the waves that
# the simulator writes of it. Values are in the waves of `blysk simulate` alone.
set -euo pipefail
layout_shows=$(readlink -f "$1")
directory=$(readlink -f "$2")
lists=("$directory"/*.f)
top=$(basename "${lists[0]}" .f)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$directory"
mapfile -t sources <"$top.f"
case $3 in
  icarus)
    # The scopes are named as Verilator names them.
    cat >"$work/bench.v" <<END
module TOP;
  $top $top ();
  initial begin
    \$dumpfile("$work/waves.vcd");
    \$dumpvars(0, TOP);
    #1 \$finish(0);
  end
endmodule
END
    iverilog -g2001 -s TOP -o "$work/bench" "${sources[@]}" "$work/bench.v"
    vvp -n "$work/bench" >"$work/log"
    ;;
  verilator)
    cat >"$work/main.cpp" <<'END'
#include <verilated_vcd_c.h>
#include "device.h"
int main(int, char** arguments) {
  Verilated::traceEverOn(true);
  device top;
  VerilatedVcdC waves;
  top.trace(&waves, 99);
  waves.open(arguments[1]);
  top.eval();
  waves.dump(0);
  top.clk = 1;
  top.eval();
  waves.dump(1);
}
END
    verilator --cc --exe --build --trace --Mdir "$work/made" --prefix device --top-module "$top" -o bench "${sources[@]}" "$work/main.cpp" >"$work/log" 2>&1 || { cat "$work/log" >&2 && exit 1; }
    "$work/made/bench" "$work/waves.vcd"
    ;;
esac
sed '/^TOP\.values\./d' "$top.gtkw" >"$work/wires.gtkw"
"$layout_shows" --all "$work/waves.vcd" "$work/wires.gtkw"
# It notices a row that shows nothing.
sed 's/\.clk$/.clock/' "$work/wires.gtkw" >"$work/spoilt.gtkw"
if "$layout_shows" --all "$work/waves.vcd" "$work/spoilt.gtkw"; then echo 'a wrong row is not noticed' >&2 && exit 1; fi
