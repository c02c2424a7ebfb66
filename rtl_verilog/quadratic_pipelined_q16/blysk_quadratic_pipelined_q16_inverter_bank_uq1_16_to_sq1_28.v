// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device quadratic-pipelined, format q16, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q16_inverter_bank_uq1_16_to_sq1_28 (
    input  wire [16:0] a_i,  // UQ1.16, codes 0..65536
    output wire signed [29:0] y_o  // SQ1.28
);

  assign y_o = ~{1'b0, a_i, 12'b0};

endmodule

`default_nettype wire
