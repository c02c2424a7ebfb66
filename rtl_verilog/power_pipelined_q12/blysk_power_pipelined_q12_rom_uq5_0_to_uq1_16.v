// SPDX-License-Identifier: Apache-2.0
// Read-only memory: y_o = the word at a_i, 0 beyond the last one.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_rom_uq5_0_to_uq1_16 (
    input  wire [4:0] a_i,  // UQ5.0
    output wire [16:0] y_o  // UQ1.16
);

  function [15:0] rom;
    input [4:0] index;
    case (index)
      5'd0: rom = 16'd65534;
      5'd1: rom = 16'd64130;
      5'd2: rom = 16'd62756;
      5'd3: rom = 16'd61411;
      5'd4: rom = 16'd60095;
      5'd5: rom = 16'd58808;
      5'd6: rom = 16'd57548;
      5'd7: rom = 16'd56314;
      5'd8: rom = 16'd55108;
      5'd9: rom = 16'd53927;
      5'd10: rom = 16'd52771;
      5'd11: rom = 16'd51641;
      5'd12: rom = 16'd50534;
      5'd13: rom = 16'd49451;
      5'd14: rom = 16'd48392;
      5'd15: rom = 16'd47355;
      5'd16: rom = 16'd46340;
      5'd17: rom = 16'd45347;
      5'd18: rom = 16'd44375;
      5'd19: rom = 16'd43425;
      5'd20: rom = 16'd42494;
      5'd21: rom = 16'd41584;
      5'd22: rom = 16'd40693;
      5'd23: rom = 16'd39821;
      5'd24: rom = 16'd38967;
      5'd25: rom = 16'd38132;
      5'd26: rom = 16'd37315;
      5'd27: rom = 16'd36516;
      5'd28: rom = 16'd35733;
      5'd29: rom = 16'd34968;
      5'd30: rom = 16'd34218;
      5'd31: rom = 16'd33485;
      default: rom = 16'd0;
    endcase
  endfunction

  assign y_o = {1'b0, rom(a_i)};

endmodule

`default_nettype wire
