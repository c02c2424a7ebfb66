// SPDX-License-Identifier: Apache-2.0
// inverter_bank<unit<10>, sq<1, 20>>, exported from the SystemC model.
`default_nettype none

module blysk_inverter_bank_unit_10_sq_1_20 (
    input  wire [10:0] a_i,
    output wire signed [21:0] y_o
);

  assign y_o = ~{1'b0, a_i, 10'b0};

endmodule

`default_nettype wire
