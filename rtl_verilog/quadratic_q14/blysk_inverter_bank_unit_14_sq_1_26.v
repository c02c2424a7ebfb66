// SPDX-License-Identifier: Apache-2.0
// inverter_bank<unit<14>, sq<1, 26>>, exported from the SystemC model.
`default_nettype none

module blysk_inverter_bank_unit_14_sq_1_26 (
    input  wire [14:0] a_i,
    output wire signed [27:0] y_o
);

  assign y_o = ~{1'b0, a_i, 12'b0};

endmodule

`default_nettype wire
