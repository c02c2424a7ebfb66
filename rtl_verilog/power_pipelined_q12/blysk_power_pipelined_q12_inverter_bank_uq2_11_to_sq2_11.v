// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_inverter_bank_uq2_11_to_sq2_11 (
    input  wire [12:0] a_i,  // UQ2.11
    output wire signed [13:0] y_o  // SQ2.11
);

  assign y_o = ~{1'b0, a_i};

endmodule

`default_nettype wire
