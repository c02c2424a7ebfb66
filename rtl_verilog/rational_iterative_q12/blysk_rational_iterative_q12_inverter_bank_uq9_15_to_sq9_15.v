// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device rational-iterative, format q12, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q12_inverter_bank_uq9_15_to_sq9_15 (
    input  wire [23:0] a_i,  // UQ9.15
    output wire signed [24:0] y_o  // SQ9.15
);

  assign y_o = ~{1'b0, a_i};

endmodule

`default_nettype wire
