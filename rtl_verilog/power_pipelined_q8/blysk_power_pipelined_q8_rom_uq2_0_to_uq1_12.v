// SPDX-License-Identifier: Apache-2.0
// Read-only memory: y_o = the word at a_i, 0 beyond the last one.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_rom_uq2_0_to_uq1_12 (
    input  wire [1:0] a_i,  // UQ2.0
    output wire [12:0] y_o  // UQ1.12
);

  function [11:0] rom;
    input [1:0] index;
    case (index)
      2'd0: rom = 12'd4090;
      2'd1: rom = 12'd3700;
      2'd2: rom = 12'd3398;
      2'd3: rom = 12'd3155;
      default: rom = 12'd0;
    endcase
  endfunction

  assign y_o = {1'b0, rom(a_i)};

endmodule

`default_nettype wire
