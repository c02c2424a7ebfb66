// SPDX-License-Identifier: Apache-2.0
// inverter_bank<unit<20>, sq<1, 32>>, exported from the SystemC model.
`default_nettype none

module blysk_inverter_bank_unit_20_sq_1_32 (
    input  wire [20:0] a_i,
    output wire signed [33:0] y_o
);

  assign y_o = ~{1'b0, a_i, 12'b0};

endmodule

`default_nettype wire
