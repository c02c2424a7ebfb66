// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device quadratic, format q20, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q20_inverter_bank_uq1_20_to_sq1_32 (
    input  wire [20:0] a_i,  // UQ1.20, codes 0..1048576
    output wire signed [33:0] y_o  // SQ1.32
);

  assign y_o = ~{1'b0, a_i, 12'b0};

endmodule

`default_nettype wire
