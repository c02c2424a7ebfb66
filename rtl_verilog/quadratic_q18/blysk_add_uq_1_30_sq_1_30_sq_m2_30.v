// SPDX-License-Identifier: Apache-2.0
// add<uq<1, 30>, sq<1, 30>, sq<-2, 30>>, exported from the SystemC model.
`default_nettype none

module blysk_add_uq_1_30_sq_1_30_sq_m2_30 (
    input  wire [30:0] a_i,
    input  wire signed [31:0] b_i,
    input  wire carry_i,
    output wire signed [28:0] s_o
);

  wire [1:0] unused_a_i_high = a_i[30:29];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[31:29];  // beyond the range of the result

  assign s_o = a_i[28:0] + b_i[28:0] + {28'b0, carry_i};

endmodule

`default_nettype wire
