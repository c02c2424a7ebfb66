// SPDX-License-Identifier: Apache-2.0
// Key block: y_o = a_i, or 0 while off_i is one.
// device cosine-quadratic, format q8, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q8_key_uq1_8 (
    input  wire [8:0] a_i,  // UQ1.8, codes 0..256
    input  wire off_i,
    output wire [8:0] y_o  // UQ1.8, codes 0..256
);

  assign y_o = off_i ? 9'd0 : a_i;

endmodule

`default_nettype wire
