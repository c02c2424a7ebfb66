// SPDX-License-Identifier: Apache-2.0
// inverter_bank<unit<12>, sq<1, 24>>, exported from the SystemC model.
`default_nettype none

module blysk_inverter_bank_unit_12_sq_1_24 (
    input  wire [12:0] a_i,
    output wire signed [25:0] y_o
);

  assign y_o = ~{1'b0, a_i, 12'b0};

endmodule

`default_nettype wire
