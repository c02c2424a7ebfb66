// SPDX-License-Identifier: Apache-2.0
// Control of a pipeline: it goes unless a result waits at its end.
// device lighting, format q12, no energy factor, exported from the SystemC model.
`default_nettype none

module blysk_lighting_q12_pipe_control (
    input  wire start_i,
    input  wire stall_i,
    input  wire valid_i,
    output wire go_o,
    output wire take_o,
    output wire ready_o
);

  assign go_o = (stall_i && valid_i) == 1'd0;
  assign take_o = start_i && (stall_i && valid_i) == 1'd0;
  assign ready_o = (stall_i && valid_i) == 1'd0;

endmodule

`default_nettype wire
