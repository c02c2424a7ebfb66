#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# lint.sh says what each tool is there to find, and nothing of a module without faults.
set -euo pipefail
lint=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lint.sh
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
echo planted.v >"$folder/planted.f"
status=0

# plant TOOL BODY [WORDS]: a module with that body is refused with words that match, or accepted if there are none.
plant() {
  echo "module planted (input wire clk, input wire [3:0] a, output wire [3:0] y); $2" >"$folder/planted.v"
  local said result=0
  said=$("$lint" "$folder" "$1" 2>&1) || result=$?
  if [ $# = 2 ] && [ $result = 0 ]; then return; fi
  if [ $# = 3 ] && [ $result = 1 ] && grep -qiE -e "$3" <<<"$said"; then return; fi
  printf '%s, status %s, on %s\n%s\n' "$1" "$result" "$2" "$said"
  status=1
}

register='reg [3:0] q; always @(posedge clk) q <= a;'
for tool in verilator icarus yosys; do
  plant $tool "$register assign y = q; endmodule"
  plant $tool "$register assign y = ; endmodule" 'syntax error'
  plant $tool "other sub (.clk(clk), .a(a), .y(y)); endmodule" '(module|type).*other'
done
plant verilator "$register assign y = {1'b0, q[2:0]}; endmodule" UNUSED
plant verilator 'reg [3:0] q; always @(posedge clk) q <= a[2:0]; assign y = q; endmodule' WIDTH
plant icarus "$register assign y = q, z = a[0]; endmodule" 'implicit definition'
plant icarus 'half sub (.clk(clk), .a(a), .y(y)); endmodule
  module half (input wire clk, input wire [2:0] a, output wire [3:0] y); assign y = {clk, a}; endmodule' 'expects 3 bits'
plant yosys 'assign y[2:0] = a[2:0] ^ {3{clk}}; endmodule' 'no driver'
plant yosys 'assign y = a; assign y = {4{clk}}; endmodule' 'conflicting drivers'
plant yosys 'reg [3:0] q; always @* if (clk) q = a; assign y = q; endmodule' latch
plant yosys 'wire [3:0] back; half one (.clk(clk), .a(back ^ a), .y(y));
  half two (.clk(clk), .a(y), .y(back)); endmodule
  module half (input wire clk, input wire [3:0] a, output wire [3:0] y); assign y = ~a & {4{clk}}; endmodule' loop

for tools in '' nothing; do
  # shellcheck disable=SC2086  # no word, or one
  if "$lint" "$folder" $tools 2>/dev/null; then
    echo "lint.sh passes with the tool '$tools'"
    status=1
  fi
done
exit $status
