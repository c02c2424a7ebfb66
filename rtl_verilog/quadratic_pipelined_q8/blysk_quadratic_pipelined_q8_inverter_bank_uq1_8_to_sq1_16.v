// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device quadratic-pipelined, format q8, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q8_inverter_bank_uq1_8_to_sq1_16 (
    input  wire [8:0] a_i,  // UQ1.8, codes 0..256
    output wire signed [17:0] y_o  // SQ1.16
);

  assign y_o = ~{1'b0, a_i, 8'b0};

endmodule

`default_nettype wire
