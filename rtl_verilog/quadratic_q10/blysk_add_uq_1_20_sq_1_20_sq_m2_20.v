// SPDX-License-Identifier: Apache-2.0
// add<uq<1, 20>, sq<1, 20>, sq<-2, 20>>, exported from the SystemC model.
`default_nettype none

module blysk_add_uq_1_20_sq_1_20_sq_m2_20 (
    input  wire [20:0] a_i,
    input  wire signed [21:0] b_i,
    input  wire carry_i,
    output wire signed [18:0] s_o
);

  wire [1:0] unused_a_i_high = a_i[20:19];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[21:19];  // beyond the range of the result

  assign s_o = a_i[18:0] + b_i[18:0] + {18'b0, carry_i};

endmodule

`default_nettype wire
