// SPDX-License-Identifier: Apache-2.0
// Digit register: the digits of d_i one after the other, the first while load_i is one.
// device gouraud, format q8, 8 shifts, exported from the SystemC model.
`default_nettype none

module blysk_gouraud_q8_digit_register_uq1_8 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [8:0] d_i,  // UQ1.8, codes 0..256
    output wire digit_o
);

  reg  [8:0] held;  // UQ1.8, codes 0..256
  wire [8:0] selected = load_i ? d_i : held;
  wire [7:0] unused_selected_low = selected[7:0];  // below the last place of the result

  assign digit_o = selected[8];
  always @(posedge clk) begin
    if (!rst_n) begin
      held <= 9'd0;
    end else if (load_i || step_i) begin
      held <= {load_i ? d_i[7:0] : held[7:0], 1'b0} & 9'd511;
    end
  end

endmodule

`default_nettype wire
