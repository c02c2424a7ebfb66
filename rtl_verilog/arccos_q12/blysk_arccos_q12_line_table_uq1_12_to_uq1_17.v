// SPDX-License-Identifier: Apache-2.0
// Straight lines between the words of a table, y_o rounded to nearest.
// device arccos, format q12, 18 digits of the root, table of 65 words, exported from the SystemC model.
`default_nettype none

module blysk_arccos_q12_line_table_uq1_12_to_uq1_17 (
    input  wire [12:0] a_i,  // UQ1.12, codes 0..4096
    output wire [17:0] y_o  // UQ1.17
);

  function [17:0] rom;
    input [6:0] index;
    case (index)
      7'd0: rom = 18'd185364;
      7'd1: rom = 18'd185606;
      7'd2: rom = 18'd185850;
      7'd3: rom = 18'd186096;
      7'd4: rom = 18'd186343;
      7'd5: rom = 18'd186592;
      7'd6: rom = 18'd186843;
      7'd7: rom = 18'd187096;
      7'd8: rom = 18'd187351;
      7'd9: rom = 18'd187608;
      7'd10: rom = 18'd187866;
      7'd11: rom = 18'd188127;
      7'd12: rom = 18'd188390;
      7'd13: rom = 18'd188654;
      7'd14: rom = 18'd188921;
      7'd15: rom = 18'd189190;
      7'd16: rom = 18'd189460;
      7'd17: rom = 18'd189733;
      7'd18: rom = 18'd190009;
      7'd19: rom = 18'd190286;
      7'd20: rom = 18'd190566;
      7'd21: rom = 18'd190848;
      7'd22: rom = 18'd191132;
      7'd23: rom = 18'd191419;
      7'd24: rom = 18'd191708;
      7'd25: rom = 18'd191999;
      7'd26: rom = 18'd192293;
      7'd27: rom = 18'd192590;
      7'd28: rom = 18'd192889;
      7'd29: rom = 18'd193191;
      7'd30: rom = 18'd193495;
      7'd31: rom = 18'd193803;
      7'd32: rom = 18'd194113;
      7'd33: rom = 18'd194425;
      7'd34: rom = 18'd194741;
      7'd35: rom = 18'd195060;
      7'd36: rom = 18'd195381;
      7'd37: rom = 18'd195706;
      7'd38: rom = 18'd196033;
      7'd39: rom = 18'd196364;
      7'd40: rom = 18'd196698;
      7'd41: rom = 18'd197036;
      7'd42: rom = 18'd197377;
      7'd43: rom = 18'd197721;
      7'd44: rom = 18'd198068;
      7'd45: rom = 18'd198420;
      7'd46: rom = 18'd198774;
      7'd47: rom = 18'd199133;
      7'd48: rom = 18'd199495;
      7'd49: rom = 18'd199862;
      7'd50: rom = 18'd200232;
      7'd51: rom = 18'd200606;
      7'd52: rom = 18'd200985;
      7'd53: rom = 18'd201367;
      7'd54: rom = 18'd201754;
      7'd55: rom = 18'd202146;
      7'd56: rom = 18'd202542;
      7'd57: rom = 18'd202942;
      7'd58: rom = 18'd203348;
      7'd59: rom = 18'd203758;
      7'd60: rom = 18'd204173;
      7'd61: rom = 18'd204594;
      7'd62: rom = 18'd205020;
      7'd63: rom = 18'd205451;
      7'd64: rom = 18'd205887;
      default: rom = 18'd0;
    endcase
  endfunction

  function [8:0] rom2;
    input [6:0] index2;
    case (index2)
      7'd0: rom2 = 9'd242;
      7'd1: rom2 = 9'd244;
      7'd2: rom2 = 9'd246;
      7'd3: rom2 = 9'd247;
      7'd4: rom2 = 9'd249;
      7'd5: rom2 = 9'd251;
      7'd6: rom2 = 9'd253;
      7'd7: rom2 = 9'd255;
      7'd8: rom2 = 9'd257;
      7'd9: rom2 = 9'd258;
      7'd10: rom2 = 9'd261;
      7'd11: rom2 = 9'd263;
      7'd12: rom2 = 9'd264;
      7'd13: rom2 = 9'd267;
      7'd14: rom2 = 9'd269;
      7'd15: rom2 = 9'd270;
      7'd16: rom2 = 9'd273;
      7'd17: rom2 = 9'd276;
      7'd18: rom2 = 9'd277;
      7'd19: rom2 = 9'd280;
      7'd20: rom2 = 9'd282;
      7'd21: rom2 = 9'd284;
      7'd22: rom2 = 9'd287;
      7'd23: rom2 = 9'd289;
      7'd24: rom2 = 9'd291;
      7'd25: rom2 = 9'd294;
      7'd26: rom2 = 9'd297;
      7'd27: rom2 = 9'd299;
      7'd28: rom2 = 9'd302;
      7'd29: rom2 = 9'd304;
      7'd30: rom2 = 9'd308;
      7'd31: rom2 = 9'd310;
      7'd32: rom2 = 9'd312;
      7'd33: rom2 = 9'd316;
      7'd34: rom2 = 9'd319;
      7'd35: rom2 = 9'd321;
      7'd36: rom2 = 9'd325;
      7'd37: rom2 = 9'd327;
      7'd38: rom2 = 9'd331;
      7'd39: rom2 = 9'd334;
      7'd40: rom2 = 9'd338;
      7'd41: rom2 = 9'd341;
      7'd42: rom2 = 9'd344;
      7'd43: rom2 = 9'd347;
      7'd44: rom2 = 9'd352;
      7'd45: rom2 = 9'd354;
      7'd46: rom2 = 9'd359;
      7'd47: rom2 = 9'd362;
      7'd48: rom2 = 9'd367;
      7'd49: rom2 = 9'd370;
      7'd50: rom2 = 9'd374;
      7'd51: rom2 = 9'd379;
      7'd52: rom2 = 9'd382;
      7'd53: rom2 = 9'd387;
      7'd54: rom2 = 9'd392;
      7'd55: rom2 = 9'd396;
      7'd56: rom2 = 9'd400;
      7'd57: rom2 = 9'd406;
      7'd58: rom2 = 9'd410;
      7'd59: rom2 = 9'd415;
      7'd60: rom2 = 9'd421;
      7'd61: rom2 = 9'd426;
      7'd62: rom2 = 9'd431;
      7'd63: rom2 = 9'd436;
      7'd64: rom2 = 9'd0;
      default: rom2 = 9'd0;
    endcase
  endfunction

  wire [6:0] shifted = a_i[12:6];
  wire [5:0] bits = a_i[5:0] & 6'd63;
  wire [14:0] product = rom2(shifted) * bits;
  wire [14:0] sum = product + 15'd32;
  wire [5:0] unused_sum_low = sum[5:0];  // below the last place of the result

  assign y_o = rom(shifted) + {9'b0, sum[14:6]};

endmodule

`default_nettype wire
