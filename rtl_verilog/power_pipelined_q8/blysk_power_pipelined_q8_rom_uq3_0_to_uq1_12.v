// SPDX-License-Identifier: Apache-2.0
// Read-only memory: y_o = the word at a_i, 0 beyond the last one.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_rom_uq3_0_to_uq1_12 (
    input  wire [2:0] a_i,  // UQ3.0
    output wire [12:0] y_o  // UQ1.12
);

  function [11:0] rom;
    input [2:0] index;
    case (index)
      3'd0: rom = 12'd4094;
      3'd1: rom = 12'd3755;
      3'd2: rom = 12'd3443;
      3'd3: rom = 12'd3157;
      3'd4: rom = 12'd2896;
      3'd5: rom = 12'd2655;
      3'd6: rom = 12'd2435;
      3'd7: rom = 12'd2233;
      default: rom = 12'd0;
    endcase
  endfunction

  assign y_o = {1'b0, rom(a_i)};

endmodule

`default_nettype wire
