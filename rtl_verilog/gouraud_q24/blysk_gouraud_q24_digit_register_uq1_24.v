// SPDX-License-Identifier: Apache-2.0
// Digit register: the digits of d_i one after the other, the first while load_i is one.
// device gouraud, format q24, 24 shifts, exported from the SystemC model.
`default_nettype none

module blysk_gouraud_q24_digit_register_uq1_24 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [24:0] d_i,  // UQ1.24, codes 0..16777216
    output wire digit_o
);

  reg  [24:0] held;  // UQ1.24, codes 0..16777216
  wire [24:0] selected = load_i ? d_i : held;
  wire [23:0] unused_selected_low = selected[23:0];  // below the last place of the result

  assign digit_o = selected[24];
  always @(posedge clk) begin
    if (!rst_n) begin
      held <= 25'd0;
    end else if (load_i || step_i) begin
      held <= {load_i ? d_i[23:0] : held[23:0], 1'b0} & 25'd33554431;
    end
  end

endmodule

`default_nettype wire
