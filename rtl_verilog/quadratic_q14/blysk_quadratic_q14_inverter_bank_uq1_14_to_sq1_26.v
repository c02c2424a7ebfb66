// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device quadratic, format q14, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q14_inverter_bank_uq1_14_to_sq1_26 (
    input  wire [14:0] a_i,  // UQ1.14, codes 0..16384
    output wire signed [27:0] y_o  // SQ1.26
);

  assign y_o = ~{1'b0, a_i, 12'b0};

endmodule

`default_nettype wire
