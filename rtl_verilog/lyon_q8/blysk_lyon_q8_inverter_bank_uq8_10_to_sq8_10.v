// SPDX-License-Identifier: Apache-2.0
// Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.
// device lyon, format q8, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q8_inverter_bank_uq8_10_to_sq8_10 (
    input  wire [17:0] a_i,  // UQ8.10
    output wire signed [18:0] y_o  // SQ8.10
);

  assign y_o = ~{1'b0, a_i};

endmodule

`default_nettype wire
