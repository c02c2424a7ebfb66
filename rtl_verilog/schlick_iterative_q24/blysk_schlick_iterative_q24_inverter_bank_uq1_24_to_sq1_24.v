// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device schlick-iterative, format q24, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q24_inverter_bank_uq1_24_to_sq1_24 (
    input  wire [24:0] a_i,  // UQ1.24, codes 0..16777216
    output wire signed [25:0] y_o  // SQ1.24
);

  assign y_o = ~{1'b0, a_i};

endmodule

`default_nettype wire
