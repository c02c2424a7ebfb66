// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device gouraud, format q24, 24 shifts, exported from the SystemC model.
`default_nettype none

module blysk_gouraud_q24_inverter_bank_uq8_0_to_sq8_0 (
    input  wire [7:0] a_i,  // UQ8.0
    output wire signed [8:0] y_o  // SQ8.0
);

  assign y_o = ~{1'b0, a_i};

endmodule

`default_nettype wire
