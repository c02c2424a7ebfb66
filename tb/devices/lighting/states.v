// SPDX-License-Identifier: Apache-2.0
// What holds for the exported lighting unit after its first reset, whatever its inputs are: see tb/cosim/states.sh. A port is
// called after the net that it reads.
`default_nettype none

module states #(
    parameter F = 8
) (
    input wire clk,
    input wire rst_n,
    input wire start_i,
    input wire stall_i,
    input wire ready_o,
    input wire valid_o,
    input wire [23:0] r_sum_o,
    input wire [23:0] g_sum_o,
    input wire [23:0] b_sum_o
);

  localparam [23:0] MOST = 255 << 16;

  // range: no sum exceeds 255, also after codes that are not legal
  always @* begin
    assert (r_sum_o <= MOST && g_sum_o <= MOST && b_sum_o <= MOST);
    assert (ready_o == !(valid_o && stall_i));
  end

`ifdef OVER_TIME
  // hold: the sums keep their values where no light is taken; protocol: valid_o is one in the cycle after a light was taken and
  // as long as stall_i holds it
  reg was_reset = 0, was_idle = 0, is_due = 0;
  reg [23:0] r_before = 0, g_before = 0, b_before = 0;
  always @(posedge clk) begin
    was_reset <= !rst_n;
    was_idle <= rst_n && !(start_i && ready_o);
    is_due <= rst_n && (start_i || valid_o && stall_i);
    r_before <= r_sum_o;
    g_before <= g_sum_o;
    b_before <= b_sum_o;
  end
  always @* begin
    assert (valid_o == is_due);
    if (was_reset) assert (r_sum_o == 0 && g_sum_o == 0 && b_sum_o == 0);
    if (was_idle) assert (r_sum_o == r_before && g_sum_o == g_before && b_sum_o == b_before);
  end
`endif

endmodule

`default_nettype wire
