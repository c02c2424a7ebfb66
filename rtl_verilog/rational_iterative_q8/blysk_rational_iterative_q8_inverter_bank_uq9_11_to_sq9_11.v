// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device rational-iterative, format q8, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q8_inverter_bank_uq9_11_to_sq9_11 (
    input  wire [19:0] a_i,  // UQ9.11
    output wire signed [20:0] y_o  // SQ9.11
);

  assign y_o = ~{1'b0, a_i};

endmodule

`default_nettype wire
