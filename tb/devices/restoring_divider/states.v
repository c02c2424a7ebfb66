// SPDX-License-Identifier: Apache-2.0
// What holds for the exported restoring divider after its first reset, whatever its inputs are: see tb/cosim/states.sh. A port
// is called after the net that it reads.
`default_nettype none

module states #(
    parameter F = 8
) (
    input wire clk,
    input wire rst_n,
    input wire start_i,
    input wire ready_o,
    input wire valid_o,
    input wire [F+8:0] increment_o,
    input wire [6:0] \control.left ,
    input wire [F+8:0] \div.digits ,
    input wire [17:0] \div.divisor ,
    input wire [18:0] \div.rest
);

  wire [6:0] left = \control.left ;
  wire [F+8:0] digits = \div.digits ;
  wire [17:0] divisor = \div.divisor ;
  wire [18:0] rest = \div.rest ;
  wire busy = left != 0;

  // range: of each register
  always @* begin
    assert (left <= F + 8);
    assert (ready_o == !busy);
    assert (!(valid_o && busy));
    // A length moved up by eight places.
    assert (divisor[7:0] == 0);
    assert (rest[0] == 0);
    if (divisor != 0) begin
      assert (rest < {divisor, 1'b0});
      // The digits so far, of which the first is 0: the dividend is below any length that is not 0.
      assert ((digits >> (F + 8 - left)) == 0);
    end else begin
      assert ((digits >> (F + 9 - left)) == 0);
    end
  end

`ifdef OVER_TIME
  // hold: increment_o keeps its value while there is no job; protocol: F + 9 edges after the one that took a row valid_o is
  // one, for one cycle, and at no other time
  reg was_reset = 0, was_idle = 0, is_due = 0;
  reg [6:0] waited = 0;
  reg [F+8:0] before = 0;
  always @(posedge clk) begin
    was_reset <= !rst_n;
    was_idle <= rst_n && ready_o && !start_i;
    before <= increment_o;
    is_due <= rst_n && waited == F + 8;
    if (!rst_n || waited == F + 8) waited <= rst_n && start_i && ready_o;
    else if (waited != 0) waited <= waited + 1;
    else waited <= start_i && ready_o;
  end
  always @* begin
    assert (waited == (busy ? F + 9 - left : 0));
    assert (valid_o == is_due);
    if (was_reset) assert (ready_o && !valid_o && increment_o == 0);
    if (was_idle) assert (increment_o == before);
  end
`endif

endmodule

`default_nettype wire
