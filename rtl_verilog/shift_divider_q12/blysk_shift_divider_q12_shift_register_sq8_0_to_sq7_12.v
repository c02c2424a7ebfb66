// SPDX-License-Identifier: Apache-2.0
// Shift register: takes d_i / 2 while load_i is one, else halves while step_i is.
// device shift-divider, format q12, 12 shifts, exported from the SystemC model.
`default_nettype none

module blysk_shift_divider_q12_shift_register_sq8_0_to_sq7_12 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire signed [8:0] d_i,  // SQ8.0, codes -255..255
    output wire signed [19:0] q_o  // SQ7.12
);

  reg  signed [19:0] held;  // SQ7.12
  wire [18:0] shifted = held[19:1];

  assign q_o = held;
  always @(posedge clk) begin
    if (!rst_n) begin
      held <= 20'd0;
    end else if (load_i || step_i) begin
      held <= load_i ? {d_i, 11'b0} : {shifted[18], shifted};
    end
  end

endmodule

`default_nettype wire
