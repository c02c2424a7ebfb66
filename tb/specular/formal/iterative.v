// SPDX-License-Identifier: Apache-2.0
// What holds for an exported iterative device that shades a point after its first reset, whatever its inputs are: see
// tb/cosim/states.sh. A port is called after the net that it reads.
`default_nettype none

module states #(
    parameter F = 8
) (
    input wire clk,
    input wire rst_n,
    input wire start_i,
    input wire ready_o,
    input wire valid_o,
    input wire [9:0] n_i,
    input wire [F:0] cos_i,
    input wire [7:0] r_i,
    input wire [7:0] g_i,
    input wire [7:0] b_i,
    input wire [6:0] \control.left ,
    input wire [F+1:0] \div.digits ,
    input wire [9:0] \rg1.q_o ,
    input wire [F:0] \rg2.q_o ,
    input wire [7:0] \rg3.q_o ,
    input wire [7:0] \rg4.q_o ,
    input wire [7:0] \rg5.q_o
);

  localparam DIGITS = F + 2;
  wire [6:0] left = \control.left ;
  wire [F+1:0] digits = \div.digits ;
  wire busy = left != 0;

  // range: the quotient has as many digits as were found
  always @* begin
    assert (left <= DIGITS);
    assert (ready_o == !busy);
    assert (!(valid_o && busy));
    if (left != DIGITS) assert (digits >> (DIGITS - left) == 0);
  end

`ifdef OVER_TIME
  // hold: registers 1 to 5 take what is at the inputs with start_i while ready_o is one, and keep it otherwise; the quotient
  // stays while there is no job, and in the cycle after the inputs were taken. protocol: DIGITS + 1 edges after the one that
  // took a point valid_o is one, for one cycle, and at no other time
  reg was_reset = 0, was_taken = 0, was_idle = 0, is_due = 0;
  reg [6:0] waited = 0;
  reg [F+34:0] given = 0, before = 0;
  reg [F+1:0] digits_before = 0;
  wire [F+34:0] held = {\rg1.q_o , \rg2.q_o , \rg3.q_o , \rg4.q_o , \rg5.q_o };
  always @(posedge clk) begin
    was_reset <= !rst_n;
    was_taken <= rst_n && start_i && ready_o;
    was_idle <= rst_n && ready_o;
    given <= {n_i, cos_i, r_i, g_i, b_i};
    before <= held;
    digits_before <= digits;
    is_due <= rst_n && waited == DIGITS;
    if (!rst_n || waited == DIGITS) waited <= 0;
    else if (waited != 0) waited <= waited + 1;
    else waited <= start_i && ready_o;
  end
  always @* begin
    assert (waited == (busy ? DIGITS + 1 - left : 0));
    assert (valid_o == is_due);
    if (was_reset) assert (ready_o && !valid_o && held == 0 && digits == 0);
    else if (was_taken) assert (held == given);
    else assert (held == before);
    if (was_idle) assert (digits == digits_before);
  end
`endif

endmodule

`default_nettype wire
