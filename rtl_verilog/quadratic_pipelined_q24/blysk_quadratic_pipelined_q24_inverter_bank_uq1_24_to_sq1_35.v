// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device quadratic-pipelined, format q24, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q24_inverter_bank_uq1_24_to_sq1_35 (
    input  wire [24:0] a_i,  // UQ1.24, codes 0..16777216
    output wire signed [36:0] y_o  // SQ1.35
);

  assign y_o = ~{1'b0, a_i, 11'b0};

endmodule

`default_nettype wire
