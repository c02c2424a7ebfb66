// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device lyon, format q12, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q12_add_uq1_0_sq8_14_to_sq8_14 (
    input  wire a_i,  // UQ1.0
    input  wire signed [22:0] b_i,  // SQ8.14
    input  wire carry_i,
    output wire signed [22:0] s_o  // SQ8.14
);

  assign s_o = {8'b0, a_i, 14'b0} + b_i + {22'b0, carry_i};

endmodule

`default_nettype wire
