// SPDX-License-Identifier: Apache-2.0
// inverter_bank<unit<16>, sq<1, 28>>, exported from the SystemC model.
`default_nettype none

module blysk_inverter_bank_unit_16_sq_1_28 (
    input  wire [16:0] a_i,
    output wire signed [29:0] y_o
);

  assign y_o = ~{1'b0, a_i, 12'b0};

endmodule

`default_nettype wire
