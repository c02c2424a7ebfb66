// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device lyon, format q16, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q16_inverter_bank_uq8_18_to_sq8_18 (
    input  wire [25:0] a_i,  // UQ8.18
    output wire signed [26:0] y_o  // SQ8.18
);

  assign y_o = ~{1'b0, a_i};

endmodule

`default_nettype wire
