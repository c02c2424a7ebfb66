// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device schlick-iterative, format q8, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q8_inverter_bank_uq1_8_to_sq1_8 (
    input  wire [8:0] a_i,  // UQ1.8, codes 0..256
    output wire signed [9:0] y_o  // SQ1.8
);

  assign y_o = ~{1'b0, a_i};

endmodule

`default_nettype wire
