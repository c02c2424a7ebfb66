// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device lyon, format q16, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q16_add_uq1_0_sq8_18_to_sq8_18 (
    input  wire a_i,  // UQ1.0
    input  wire signed [26:0] b_i,  // SQ8.18
    input  wire carry_i,
    output wire signed [26:0] s_o  // SQ8.18
);

  assign s_o = {8'b0, a_i, 18'b0} + b_i + {26'b0, carry_i};

endmodule

`default_nettype wire
