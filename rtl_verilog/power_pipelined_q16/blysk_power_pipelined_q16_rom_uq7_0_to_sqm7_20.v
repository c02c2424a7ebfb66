// SPDX-License-Identifier: Apache-2.0
// Read-only memory: y_o = the word at a_i, 0 beyond the last one.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_rom_uq7_0_to_sqm7_20 (
    input  wire [6:0] a_i,  // UQ7.0
    output wire signed [13:0] y_o  // SQ-7.20
);

  function [13:0] rom;
    input [6:0] index;
    case (index)
      7'd0: rom = 14'd10721;
      7'd1: rom = 14'd10752;
      7'd2: rom = 14'd10782;
      7'd3: rom = 14'd10812;
      7'd4: rom = 14'd10842;
      7'd5: rom = 14'd10872;
      7'd6: rom = 14'd10902;
      7'd7: rom = 14'd10932;
      7'd8: rom = 14'd10961;
      7'd9: rom = 14'd10990;
      7'd10: rom = 14'd11020;
      7'd11: rom = 14'd11049;
      7'd12: rom = 14'd11077;
      7'd13: rom = 14'd11106;
      7'd14: rom = 14'd11135;
      7'd15: rom = 14'd11163;
      7'd16: rom = 14'd11191;
      7'd17: rom = 14'd11219;
      7'd18: rom = 14'd11247;
      7'd19: rom = 14'd11275;
      7'd20: rom = 14'd11302;
      7'd21: rom = 14'd11330;
      7'd22: rom = 14'd11357;
      7'd23: rom = 14'd11384;
      7'd24: rom = 14'd11411;
      7'd25: rom = 14'd11438;
      7'd26: rom = 14'd11465;
      7'd27: rom = 14'd11491;
      7'd28: rom = 14'd11518;
      7'd29: rom = 14'd11544;
      7'd30: rom = 14'd11570;
      7'd31: rom = 14'd11596;
      7'd32: rom = 14'd11622;
      7'd33: rom = 14'd11648;
      7'd34: rom = 14'd11673;
      7'd35: rom = 14'd11699;
      7'd36: rom = 14'd11724;
      7'd37: rom = 14'd11749;
      7'd38: rom = 14'd11774;
      7'd39: rom = 14'd11799;
      7'd40: rom = 14'd11824;
      7'd41: rom = 14'd11849;
      7'd42: rom = 14'd11873;
      7'd43: rom = 14'd11897;
      7'd44: rom = 14'd11922;
      7'd45: rom = 14'd11946;
      7'd46: rom = 14'd11970;
      7'd47: rom = 14'd11994;
      7'd48: rom = 14'd12017;
      7'd49: rom = 14'd12041;
      7'd50: rom = 14'd12064;
      7'd51: rom = 14'd12088;
      7'd52: rom = 14'd12111;
      7'd53: rom = 14'd12134;
      7'd54: rom = 14'd12157;
      7'd55: rom = 14'd12180;
      7'd56: rom = 14'd12202;
      7'd57: rom = 14'd12225;
      7'd58: rom = 14'd12247;
      7'd59: rom = 14'd12270;
      7'd60: rom = 14'd12292;
      7'd61: rom = 14'd12314;
      7'd62: rom = 14'd12336;
      7'd63: rom = 14'd12358;
      7'd64: rom = 14'd12380;
      7'd65: rom = 14'd12401;
      7'd66: rom = 14'd12423;
      7'd67: rom = 14'd12444;
      7'd68: rom = 14'd12466;
      7'd69: rom = 14'd12487;
      7'd70: rom = 14'd12508;
      7'd71: rom = 14'd12529;
      7'd72: rom = 14'd12549;
      7'd73: rom = 14'd12570;
      7'd74: rom = 14'd12591;
      7'd75: rom = 14'd12611;
      7'd76: rom = 14'd12632;
      7'd77: rom = 14'd12652;
      7'd78: rom = 14'd12672;
      7'd79: rom = 14'd12692;
      7'd80: rom = 14'd12712;
      7'd81: rom = 14'd12732;
      7'd82: rom = 14'd12752;
      7'd83: rom = 14'd12771;
      7'd84: rom = 14'd12791;
      7'd85: rom = 14'd12810;
      7'd86: rom = 14'd12829;
      7'd87: rom = 14'd12849;
      7'd88: rom = 14'd12868;
      7'd89: rom = 14'd12887;
      7'd90: rom = 14'd12906;
      7'd91: rom = 14'd12924;
      7'd92: rom = 14'd12943;
      7'd93: rom = 14'd12962;
      7'd94: rom = 14'd12980;
      7'd95: rom = 14'd12999;
      7'd96: rom = 14'd13017;
      7'd97: rom = 14'd13035;
      7'd98: rom = 14'd13053;
      7'd99: rom = 14'd13071;
      7'd100: rom = 14'd13089;
      7'd101: rom = 14'd13107;
      7'd102: rom = 14'd13124;
      7'd103: rom = 14'd13142;
      7'd104: rom = 14'd13160;
      7'd105: rom = 14'd13177;
      7'd106: rom = 14'd13194;
      7'd107: rom = 14'd13212;
      7'd108: rom = 14'd13229;
      7'd109: rom = 14'd13246;
      7'd110: rom = 14'd13263;
      7'd111: rom = 14'd13280;
      7'd112: rom = 14'd13296;
      7'd113: rom = 14'd13313;
      7'd114: rom = 14'd13330;
      7'd115: rom = 14'd13346;
      7'd116: rom = 14'd13362;
      7'd117: rom = 14'd13379;
      7'd118: rom = 14'd13395;
      7'd119: rom = 14'd13411;
      7'd120: rom = 14'd13427;
      7'd121: rom = 14'd13443;
      7'd122: rom = 14'd13459;
      7'd123: rom = 14'd13475;
      7'd124: rom = 14'd13491;
      7'd125: rom = 14'd13506;
      7'd126: rom = 14'd13522;
      7'd127: rom = 14'd13537;
      default: rom = 14'd0;
    endcase
  endfunction

  assign y_o = rom(a_i);

endmodule

`default_nettype wire
