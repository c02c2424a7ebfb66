// SPDX-License-Identifier: Apache-2.0
// What holds for the exported arc-cosine unit after its first reset, whatever its inputs are: see tb/cosim/states.sh. A port is
// called after the net that it reads.
`default_nettype none

module states #(
    parameter F = 8
) (
    input wire clk,
    input wire rst_n,
    input wire start_i,
    input wire ready_o,
    input wire valid_o,
    input wire [F:0] cos_i,
    input wire [6:0] \control.left ,
    input wire [F+5:0] \root.digits ,
    input wire [F+6:0] \root.remainder ,
    input wire [F:0] \rg_versine.q_o
);

  localparam STEPS = F + 6;
  wire [6:0] left = \control.left ;
  wire busy = left != 0;

  // range: the root has as many digits as steps were made; its remainder is at most twice the root
  always @* begin
    assert (left <= STEPS);
    assert (ready_o == !busy);
    assert (!(valid_o && busy));
    assert (\root.digits >> (STEPS - left) == 0);
    assert (\root.remainder <= {\root.digits , 1'b0});
  end

`ifdef OVER_TIME
  // hold: the root, and the versine that its ratio comes from, keep their values while there is no job; protocol: STEPS + 1
  // edges after the one that took a cosine valid_o is one, for one cycle, and at no other time
  reg was_reset = 0, was_idle = 0, is_due = 0;
  reg [6:0] waited = 0;
  reg [F+5:0] root_before = 0;
  reg [F:0] versine_before = 0;
  always @(posedge clk) begin
    was_reset <= !rst_n;
    was_idle <= rst_n && ready_o && !start_i;
    root_before <= \root.digits ;
    versine_before <= \rg_versine.q_o ;
    is_due <= rst_n && waited == STEPS;
    if (!rst_n || waited == STEPS) waited <= 0;
    else if (waited != 0) waited <= waited + 1;
    else waited <= start_i && ready_o;
  end
  always @* begin
    assert (waited == (busy ? STEPS + 1 - left : 0));
    assert (valid_o == is_due);
    if (was_reset) assert (ready_o && !valid_o && \root.digits == 0);
    if (was_idle) assert (\root.digits == root_before);
    if (was_idle || busy && waited > 1) assert (\rg_versine.q_o == versine_before);
  end
`endif

endmodule

`default_nettype wire
