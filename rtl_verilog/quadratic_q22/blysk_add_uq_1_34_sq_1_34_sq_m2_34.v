// SPDX-License-Identifier: Apache-2.0
// add<uq<1, 34>, sq<1, 34>, sq<-2, 34>>, exported from the SystemC model.
`default_nettype none

module blysk_add_uq_1_34_sq_1_34_sq_m2_34 (
    input  wire [34:0] a_i,
    input  wire signed [35:0] b_i,
    input  wire carry_i,
    output wire signed [32:0] s_o
);

  wire [1:0] unused_a_i_high = a_i[34:33];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[35:33];  // beyond the range of the result

  assign s_o = a_i[32:0] + b_i[32:0] + {32'b0, carry_i};

endmodule

`default_nettype wire
