// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device lyon, format q24, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q24_inverter_bank_uq8_26_to_sq8_26 (
    input  wire [33:0] a_i,  // UQ8.26
    output wire signed [34:0] y_o  // SQ8.26
);

  assign y_o = ~{1'b0, a_i};

endmodule

`default_nettype wire
