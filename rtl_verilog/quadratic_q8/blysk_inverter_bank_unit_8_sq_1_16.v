// SPDX-License-Identifier: Apache-2.0
// inverter_bank<unit<8>, sq<1, 16>>, exported from the SystemC model.
`default_nettype none

module blysk_inverter_bank_unit_8_sq_1_16 (
    input  wire [8:0] a_i,
    output wire signed [17:0] y_o
);

  assign y_o = ~{1'b0, a_i, 8'b0};

endmodule

`default_nettype wire
