// SPDX-License-Identifier: Apache-2.0
// Shift register: takes d_i / 2 while load_i is one, else halves while step_i is.
// device shift-divider, format q8, 8 shifts, exported from the SystemC model.
`default_nettype none

module blysk_shift_divider_q8_shift_register_sq8_0_to_sq7_8 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire signed [8:0] d_i,  // SQ8.0, codes -255..255
    output wire signed [15:0] q_o  // SQ7.8
);

  reg  signed [15:0] held;  // SQ7.8
  wire [14:0] shifted = held[15:1];

  assign q_o = held;
  always @(posedge clk) begin
    if (!rst_n) begin
      held <= 16'd0;
    end else if (load_i || step_i) begin
      held <= load_i ? {d_i, 7'b0} : {shifted[14], shifted};
    end
  end

endmodule

`default_nettype wire
