// SPDX-License-Identifier: Apache-2.0
// Read-only memory: y_o = the word at a_i, 0 beyond the last one.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_rom_uq3_0_to_sqm3_12 (
    input  wire [2:0] a_i,  // UQ3.0
    output wire signed [9:0] y_o  // SQ-3.12
);

  function [9:0] rom;
    input [2:0] index;
    case (index)
      3'd0: rom = 10'd684;
      3'd1: rom = 10'd712;
      3'd2: rom = 10'd738;
      3'd3: rom = 10'd762;
      3'd4: rom = 10'd784;
      3'd5: rom = 10'd804;
      3'd6: rom = 10'd822;
      3'd7: rom = 10'd839;
      default: rom = 10'd0;
    endcase
  endfunction

  assign y_o = rom(a_i);

endmodule

`default_nettype wire
