// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device lyon, format q12, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q12_inverter_bank_uq8_14_to_sq8_14 (
    input  wire [21:0] a_i,  // UQ8.14
    output wire signed [22:0] y_o  // SQ8.14
);

  assign y_o = ~{1'b0, a_i};

endmodule

`default_nettype wire
