// SPDX-License-Identifier: Apache-2.0
// Read-only memory: y_o = the word at a_i, 0 beyond the last one.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_rom_uq4_0_to_sqm5_16 (
    input  wire [3:0] a_i,  // UQ4.0
    output wire signed [11:0] y_o  // SQ-5.16
);

  function [11:0] rom;
    input [3:0] index;
    case (index)
      4'd0: rom = 12'd2351;
      4'd1: rom = 12'd2476;
      4'd2: rom = 12'd2587;
      4'd3: rom = 12'd2685;
      4'd4: rom = 12'd2773;
      4'd5: rom = 12'd2851;
      4'd6: rom = 12'd2922;
      4'd7: rom = 12'd2987;
      4'd8: rom = 12'd3045;
      4'd9: rom = 12'd3099;
      4'd10: rom = 12'd3148;
      4'd11: rom = 12'd3193;
      4'd12: rom = 12'd3234;
      4'd13: rom = 12'd3273;
      4'd14: rom = 12'd3309;
      4'd15: rom = 12'd3342;
      default: rom = 12'd0;
    endcase
  endfunction

  assign y_o = rom(a_i);

endmodule

`default_nettype wire
