// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_inverter_bank_uq2_7_to_sq2_7 (
    input  wire [8:0] a_i,  // UQ2.7
    output wire signed [9:0] y_o  // SQ2.7
);

  assign y_o = ~{1'b0, a_i};

endmodule

`default_nettype wire
