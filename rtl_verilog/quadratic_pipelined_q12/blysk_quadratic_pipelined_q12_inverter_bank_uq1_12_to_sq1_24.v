// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device quadratic-pipelined, format q12, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q12_inverter_bank_uq1_12_to_sq1_24 (
    input  wire [12:0] a_i,  // UQ1.12, codes 0..4096
    output wire signed [25:0] y_o  // SQ1.24
);

  assign y_o = ~{1'b0, a_i, 12'b0};

endmodule

`default_nettype wire
