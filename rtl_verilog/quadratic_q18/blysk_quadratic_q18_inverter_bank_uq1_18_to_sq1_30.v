// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device quadratic, format q18, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q18_inverter_bank_uq1_18_to_sq1_30 (
    input  wire [18:0] a_i,  // UQ1.18, codes 0..262144
    output wire signed [31:0] y_o  // SQ1.30
);

  assign y_o = ~{1'b0, a_i, 12'b0};

endmodule

`default_nettype wire
