// SPDX-License-Identifier: Apache-2.0
// add<uq<1, 35>, sq<1, 35>, sq<-2, 35>>, exported from the SystemC model.
`default_nettype none

module blysk_add_uq_1_35_sq_1_35_sq_m2_35 (
    input  wire [35:0] a_i,
    input  wire signed [36:0] b_i,
    input  wire carry_i,
    output wire signed [33:0] s_o
);

  wire [1:0] unused_a_i_high = a_i[35:34];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[36:34];  // beyond the range of the result

  assign s_o = a_i[33:0] + b_i[33:0] + {33'b0, carry_i};

endmodule

`default_nettype wire
