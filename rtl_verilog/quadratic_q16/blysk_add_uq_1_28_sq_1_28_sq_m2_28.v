// SPDX-License-Identifier: Apache-2.0
// add<uq<1, 28>, sq<1, 28>, sq<-2, 28>>, exported from the SystemC model.
`default_nettype none

module blysk_add_uq_1_28_sq_1_28_sq_m2_28 (
    input  wire [28:0] a_i,
    input  wire signed [29:0] b_i,
    input  wire carry_i,
    output wire signed [26:0] s_o
);

  wire [1:0] unused_a_i_high = a_i[28:27];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[29:27];  // beyond the range of the result

  assign s_o = a_i[26:0] + b_i[26:0] + {26'b0, carry_i};

endmodule

`default_nettype wire
