// SPDX-License-Identifier: Apache-2.0
// inverter_bank<unit<24>, sq<1, 35>>, exported from the SystemC model.
`default_nettype none

module blysk_inverter_bank_unit_24_sq_1_35 (
    input  wire [24:0] a_i,
    output wire signed [36:0] y_o
);

  assign y_o = ~{1'b0, a_i, 11'b0};

endmodule

`default_nettype wire
