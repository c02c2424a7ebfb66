// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device power-pipelined, format q24, 1024 lines for the logarithm, 2048 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q24_inverter_bank_uq2_23_to_sq2_23 (
    input  wire [24:0] a_i,  // UQ2.23
    output wire signed [25:0] y_o  // SQ2.23
);

  assign y_o = ~{1'b0, a_i};

endmodule

`default_nettype wire
