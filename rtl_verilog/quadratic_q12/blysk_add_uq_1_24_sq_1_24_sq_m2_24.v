// SPDX-License-Identifier: Apache-2.0
// add<uq<1, 24>, sq<1, 24>, sq<-2, 24>>, exported from the SystemC model.
`default_nettype none

module blysk_add_uq_1_24_sq_1_24_sq_m2_24 (
    input  wire [24:0] a_i,
    input  wire signed [25:0] b_i,
    input  wire carry_i,
    output wire signed [22:0] s_o
);

  wire [1:0] unused_a_i_high = a_i[24:23];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[25:23];  // beyond the range of the result

  assign s_o = a_i[22:0] + b_i[22:0] + {22'b0, carry_i};

endmodule

`default_nettype wire
