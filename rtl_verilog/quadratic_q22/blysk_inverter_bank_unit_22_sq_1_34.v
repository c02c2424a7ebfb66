// SPDX-License-Identifier: Apache-2.0
// inverter_bank<unit<22>, sq<1, 34>>, exported from the SystemC model.
`default_nettype none

module blysk_inverter_bank_unit_22_sq_1_34 (
    input  wire [22:0] a_i,
    output wire signed [35:0] y_o
);

  assign y_o = ~{1'b0, a_i, 12'b0};

endmodule

`default_nettype wire
