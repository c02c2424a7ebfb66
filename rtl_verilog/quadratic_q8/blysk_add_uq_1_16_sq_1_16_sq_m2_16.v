// SPDX-License-Identifier: Apache-2.0
// add<uq<1, 16>, sq<1, 16>, sq<-2, 16>>, exported from the SystemC model.
`default_nettype none

module blysk_add_uq_1_16_sq_1_16_sq_m2_16 (
    input  wire [16:0] a_i,
    input  wire signed [17:0] b_i,
    input  wire carry_i,
    output wire signed [14:0] s_o
);

  wire [1:0] unused_a_i_high = a_i[16:15];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[17:15];  // beyond the range of the result

  assign s_o = a_i[14:0] + b_i[14:0] + {14'b0, carry_i};

endmodule

`default_nettype wire
