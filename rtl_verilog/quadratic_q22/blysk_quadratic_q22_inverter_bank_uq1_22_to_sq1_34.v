// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device quadratic, format q22, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q22_inverter_bank_uq1_22_to_sq1_34 (
    input  wire [22:0] a_i,  // UQ1.22, codes 0..4194304
    output wire signed [35:0] y_o  // SQ1.34
);

  assign y_o = ~{1'b0, a_i, 12'b0};

endmodule

`default_nettype wire
