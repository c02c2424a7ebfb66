// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device quadratic, format q10, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q10_inverter_bank_uq1_10_to_sq1_20 (
    input  wire [10:0] a_i,  // UQ1.10, codes 0..1024
    output wire signed [21:0] y_o  // SQ1.20
);

  assign y_o = ~{1'b0, a_i, 10'b0};

endmodule

`default_nettype wire
