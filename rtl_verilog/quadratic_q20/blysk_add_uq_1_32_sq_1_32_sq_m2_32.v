// SPDX-License-Identifier: Apache-2.0
// add<uq<1, 32>, sq<1, 32>, sq<-2, 32>>, exported from the SystemC model.
`default_nettype none

module blysk_add_uq_1_32_sq_1_32_sq_m2_32 (
    input  wire [32:0] a_i,
    input  wire signed [33:0] b_i,
    input  wire carry_i,
    output wire signed [30:0] s_o
);

  wire [1:0] unused_a_i_high = a_i[32:31];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[33:31];  // beyond the range of the result

  assign s_o = a_i[30:0] + b_i[30:0] + {30'b0, carry_i};

endmodule

`default_nettype wire
