// SPDX-License-Identifier: Apache-2.0
// Read-only memory: y_o = the word at a_i, 0 beyond the last one.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_rom_uq4_0_to_uq1_16 (
    input  wire [3:0] a_i,  // UQ4.0
    output wire [16:0] y_o  // UQ1.16
);

  function [15:0] rom;
    input [3:0] index;
    case (index)
      4'd0: rom = 16'd65529;
      4'd1: rom = 16'd63785;
      4'd2: rom = 16'd62166;
      4'd3: rom = 16'd60657;
      4'd4: rom = 16'd59247;
      4'd5: rom = 16'd57924;
      4'd6: rom = 16'd56679;
      4'd7: rom = 16'd55506;
      4'd8: rom = 16'd54397;
      4'd9: rom = 16'd53347;
      4'd10: rom = 16'd52350;
      4'd11: rom = 16'd51402;
      4'd12: rom = 16'd50499;
      4'd13: rom = 16'd49638;
      4'd14: rom = 16'd48815;
      4'd15: rom = 16'd48028;
      default: rom = 16'd0;
    endcase
  endfunction

  assign y_o = {1'b0, rom(a_i)};

endmodule

`default_nettype wire
