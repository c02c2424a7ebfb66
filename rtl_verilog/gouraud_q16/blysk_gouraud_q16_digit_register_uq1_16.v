// SPDX-License-Identifier: Apache-2.0
// Digit register: the digits of d_i one after the other, the first while load_i is one.
// device gouraud, format q16, 16 shifts, exported from the SystemC model.
`default_nettype none

module blysk_gouraud_q16_digit_register_uq1_16 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [16:0] d_i,  // UQ1.16, codes 0..65536
    output wire digit_o
);

  reg  [16:0] held;  // UQ1.16, codes 0..65536
  wire [16:0] selected = load_i ? d_i : held;
  wire [15:0] unused_selected_low = selected[15:0];  // below the last place of the result

  assign digit_o = selected[16];
  always @(posedge clk) begin
    if (!rst_n) begin
      held <= 17'd0;
    end else if (load_i || step_i) begin
      held <= {load_i ? d_i[15:0] : held[15:0], 1'b0} & 17'd131071;
    end
  end

endmodule

`default_nettype wire
