// SPDX-License-Identifier: Apache-2.0
// Digit register: the digits of d_i one after the other, the first while load_i is one.
// device shift-divider, format q12, 12 shifts, exported from the SystemC model.
`default_nettype none

module blysk_shift_divider_q12_digit_register_uq1_12 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [12:0] d_i,  // UQ1.12, codes 0..4096
    output wire digit_o
);

  reg  [12:0] held;  // UQ1.12, codes 0..4096
  wire [12:0] selected = load_i ? d_i : held;
  wire [11:0] unused_selected_low = selected[11:0];  // below the last place of the result

  assign digit_o = selected[12];
  always @(posedge clk) begin
    if (!rst_n) begin
      held <= 13'd0;
    end else if (load_i || step_i) begin
      held <= {load_i ? d_i[11:0] : held[11:0], 1'b0} & 13'd8191;
    end
  end

endmodule

`default_nettype wire
