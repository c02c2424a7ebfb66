// SPDX-License-Identifier: Apache-2.0
// Read-only memory: y_o = the word at a_i, 0 beyond the last one.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_rom_uq5_0_to_sqm5_16 (
    input  wire [4:0] a_i,  // UQ5.0
    output wire signed [11:0] y_o  // SQ-5.16
);

  function [11:0] rom;
    input [4:0] index;
    case (index)
      5'd0: rom = 12'd2692;
      5'd1: rom = 12'd2722;
      5'd2: rom = 12'd2751;
      5'd3: rom = 12'd2780;
      5'd4: rom = 12'd2808;
      5'd5: rom = 12'd2836;
      5'd6: rom = 12'd2863;
      5'd7: rom = 12'd2889;
      5'd8: rom = 12'd2915;
      5'd9: rom = 12'd2940;
      5'd10: rom = 12'd2965;
      5'd11: rom = 12'd2989;
      5'd12: rom = 12'd3013;
      5'd13: rom = 12'd3036;
      5'd14: rom = 12'd3059;
      5'd15: rom = 12'd3081;
      5'd16: rom = 12'd3103;
      5'd17: rom = 12'd3124;
      5'd18: rom = 12'd3145;
      5'd19: rom = 12'd3165;
      5'd20: rom = 12'd3185;
      5'd21: rom = 12'd3205;
      5'd22: rom = 12'd3224;
      5'd23: rom = 12'd3243;
      5'd24: rom = 12'd3261;
      5'd25: rom = 12'd3279;
      5'd26: rom = 12'd3296;
      5'd27: rom = 12'd3314;
      5'd28: rom = 12'd3330;
      5'd29: rom = 12'd3347;
      5'd30: rom = 12'd3363;
      5'd31: rom = 12'd3378;
      default: rom = 12'd0;
    endcase
  endfunction

  assign y_o = rom(a_i);

endmodule

`default_nettype wire
