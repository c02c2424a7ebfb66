// SPDX-License-Identifier: Apache-2.0
// Constant: y_o = RAW, the integer on the wires.
// device rational-iterative, format q8, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q8_constant_uq1_0 #(
    parameter RAW = 1'd0
) (
    output wire y_o  // UQ1.0
);

  assign y_o = RAW;

endmodule

`default_nettype wire
