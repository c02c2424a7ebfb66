// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device schlick-iterative, format q12, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q12_inverter_bank_uq1_12_to_sq1_12 (
    input  wire [12:0] a_i,  // UQ1.12, codes 0..4096
    output wire signed [13:0] y_o  // SQ1.12
);

  assign y_o = ~{1'b0, a_i};

endmodule

`default_nettype wire
