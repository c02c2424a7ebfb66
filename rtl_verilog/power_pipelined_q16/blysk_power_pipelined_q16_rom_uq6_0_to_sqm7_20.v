// SPDX-License-Identifier: Apache-2.0
// Read-only memory: y_o = the word at a_i, 0 beyond the last one.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_rom_uq6_0_to_sqm7_20 (
    input  wire [5:0] a_i,  // UQ6.0
    output wire signed [13:0] y_o  // SQ-7.20
);

  function [13:0] rom;
    input [5:0] index;
    case (index)
      6'd0: rom = 14'd9201;
      6'd1: rom = 14'd9339;
      6'd2: rom = 14'd9473;
      6'd3: rom = 14'd9602;
      6'd4: rom = 14'd9727;
      6'd5: rom = 14'd9848;
      6'd6: rom = 14'd9965;
      6'd7: rom = 14'd10079;
      6'd8: rom = 14'd10189;
      6'd9: rom = 14'd10297;
      6'd10: rom = 14'd10400;
      6'd11: rom = 14'd10501;
      6'd12: rom = 14'd10599;
      6'd13: rom = 14'd10695;
      6'd14: rom = 14'd10787;
      6'd15: rom = 14'd10877;
      6'd16: rom = 14'd10965;
      6'd17: rom = 14'd11050;
      6'd18: rom = 14'd11133;
      6'd19: rom = 14'd11214;
      6'd20: rom = 14'd11292;
      6'd21: rom = 14'd11369;
      6'd22: rom = 14'd11444;
      6'd23: rom = 14'd11516;
      6'd24: rom = 14'd11587;
      6'd25: rom = 14'd11656;
      6'd26: rom = 14'd11724;
      6'd27: rom = 14'd11790;
      6'd28: rom = 14'd11854;
      6'd29: rom = 14'd11917;
      6'd30: rom = 14'd11978;
      6'd31: rom = 14'd12038;
      6'd32: rom = 14'd12097;
      6'd33: rom = 14'd12154;
      6'd34: rom = 14'd12210;
      6'd35: rom = 14'd12265;
      6'd36: rom = 14'd12318;
      6'd37: rom = 14'd12370;
      6'd38: rom = 14'd12421;
      6'd39: rom = 14'd12472;
      6'd40: rom = 14'd12521;
      6'd41: rom = 14'd12568;
      6'd42: rom = 14'd12615;
      6'd43: rom = 14'd12661;
      6'd44: rom = 14'd12706;
      6'd45: rom = 14'd12751;
      6'd46: rom = 14'd12794;
      6'd47: rom = 14'd12836;
      6'd48: rom = 14'd12878;
      6'd49: rom = 14'd12918;
      6'd50: rom = 14'd12958;
      6'd51: rom = 14'd12997;
      6'd52: rom = 14'd13036;
      6'd53: rom = 14'd13073;
      6'd54: rom = 14'd13110;
      6'd55: rom = 14'd13147;
      6'd56: rom = 14'd13182;
      6'd57: rom = 14'd13217;
      6'd58: rom = 14'd13251;
      6'd59: rom = 14'd13285;
      6'd60: rom = 14'd13318;
      6'd61: rom = 14'd13351;
      6'd62: rom = 14'd13383;
      6'd63: rom = 14'd13414;
      default: rom = 14'd0;
    endcase
  endfunction

  assign y_o = rom(a_i);

endmodule

`default_nettype wire
