// SPDX-License-Identifier: Apache-2.0
// inverter_bank<unit<18>, sq<1, 30>>, exported from the SystemC model.
`default_nettype none

module blysk_inverter_bank_unit_18_sq_1_30 (
    input  wire [18:0] a_i,
    output wire signed [31:0] y_o
);

  assign y_o = ~{1'b0, a_i, 12'b0};

endmodule

`default_nettype wire
