// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device cosine-quadratic, format q12, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q12_add_uq1_12_sq0_0_to_sq0_12 (
    input  wire [12:0] a_i,  // UQ1.12, codes 0..4096
    input  wire signed b_i,  // SQ0.0
    input  wire carry_i,
    output wire signed [12:0] s_o  // SQ0.12
);

  assign s_o = a_i + {b_i, 12'b0} + {12'b0, carry_i};

endmodule

`default_nettype wire
