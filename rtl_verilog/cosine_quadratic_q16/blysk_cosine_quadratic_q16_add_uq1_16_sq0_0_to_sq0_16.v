// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device cosine-quadratic, format q16, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q16_add_uq1_16_sq0_0_to_sq0_16 (
    input  wire [16:0] a_i,  // UQ1.16, codes 0..65536
    input  wire signed b_i,  // SQ0.0
    input  wire carry_i,
    output wire signed [16:0] s_o  // SQ0.16
);

  assign s_o = a_i + {b_i, 16'b0} + {16'b0, carry_i};

endmodule

`default_nettype wire
