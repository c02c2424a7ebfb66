// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device schlick-iterative, format q16, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q16_inverter_bank_uq1_16_to_sq1_16 (
    input  wire [16:0] a_i,  // UQ1.16, codes 0..65536
    output wire signed [17:0] y_o  // SQ1.16
);

  assign y_o = ~{1'b0, a_i};

endmodule

`default_nettype wire
