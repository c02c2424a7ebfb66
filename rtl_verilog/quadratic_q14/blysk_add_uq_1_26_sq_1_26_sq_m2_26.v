// SPDX-License-Identifier: Apache-2.0
// add<uq<1, 26>, sq<1, 26>, sq<-2, 26>>, exported from the SystemC model.
`default_nettype none

module blysk_add_uq_1_26_sq_1_26_sq_m2_26 (
    input  wire [26:0] a_i,
    input  wire signed [27:0] b_i,
    input  wire carry_i,
    output wire signed [24:0] s_o
);

  wire [1:0] unused_a_i_high = a_i[26:25];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[27:25];  // beyond the range of the result

  assign s_o = a_i[24:0] + b_i[24:0] + {24'b0, carry_i};

endmodule

`default_nettype wire
