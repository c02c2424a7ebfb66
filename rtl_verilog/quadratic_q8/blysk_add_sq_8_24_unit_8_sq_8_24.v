// SPDX-License-Identifier: Apache-2.0
// add<sq<8, 24>, unit<8>, sq<8, 24>>, exported from the SystemC model.
`default_nettype none

module blysk_add_sq_8_24_unit_8_sq_8_24 (
    input  wire signed [32:0] a_i,
    input  wire [8:0] b_i,
    input  wire carry_i,
    output wire signed [32:0] s_o
);

  assign s_o = a_i + {8'b0, b_i, 16'b0} + {32'b0, carry_i};

endmodule

`default_nettype wire
