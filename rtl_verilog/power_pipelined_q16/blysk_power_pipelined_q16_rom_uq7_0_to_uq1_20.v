// SPDX-License-Identifier: Apache-2.0
// Read-only memory: y_o = the word at a_i, 0 beyond the last one.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_rom_uq7_0_to_uq1_20 (
    input  wire [6:0] a_i,  // UQ7.0
    output wire [20:0] y_o  // UQ1.20
);

  function [19:0] rom;
    input [6:0] index;
    case (index)
      7'd0: rom = 20'd1048574;
      7'd1: rom = 20'd1042911;
      7'd2: rom = 20'd1037279;
      7'd3: rom = 20'd1031677;
      7'd4: rom = 20'd1026106;
      7'd5: rom = 20'd1020564;
      7'd6: rom = 20'd1015052;
      7'd7: rom = 20'd1009571;
      7'd8: rom = 20'd1004118;
      7'd9: rom = 20'd998696;
      7'd10: rom = 20'd993302;
      7'd11: rom = 20'd987938;
      7'd12: rom = 20'd982602;
      7'd13: rom = 20'd977296;
      7'd14: rom = 20'd972018;
      7'd15: rom = 20'd966768;
      7'd16: rom = 20'd961547;
      7'd17: rom = 20'd956354;
      7'd18: rom = 20'd951189;
      7'd19: rom = 20'd946052;
      7'd20: rom = 20'd940943;
      7'd21: rom = 20'd935861;
      7'd22: rom = 20'd930807;
      7'd23: rom = 20'd925780;
      7'd24: rom = 20'd920781;
      7'd25: rom = 20'd915808;
      7'd26: rom = 20'd910862;
      7'd27: rom = 20'd905943;
      7'd28: rom = 20'd901050;
      7'd29: rom = 20'd896184;
      7'd30: rom = 20'd891344;
      7'd31: rom = 20'd886530;
      7'd32: rom = 20'd881743;
      7'd33: rom = 20'd876981;
      7'd34: rom = 20'd872244;
      7'd35: rom = 20'd867534;
      7'd36: rom = 20'd862849;
      7'd37: rom = 20'd858189;
      7'd38: rom = 20'd853554;
      7'd39: rom = 20'd848944;
      7'd40: rom = 20'd844360;
      7'd41: rom = 20'd839800;
      7'd42: rom = 20'd835264;
      7'd43: rom = 20'd830753;
      7'd44: rom = 20'd826267;
      7'd45: rom = 20'd821804;
      7'd46: rom = 20'd817366;
      7'd47: rom = 20'd812952;
      7'd48: rom = 20'd808562;
      7'd49: rom = 20'd804195;
      7'd50: rom = 20'd799852;
      7'd51: rom = 20'd795532;
      7'd52: rom = 20'd791236;
      7'd53: rom = 20'd786963;
      7'd54: rom = 20'd782713;
      7'd55: rom = 20'd778486;
      7'd56: rom = 20'd774281;
      7'd57: rom = 20'd770100;
      7'd58: rom = 20'd765941;
      7'd59: rom = 20'd761804;
      7'd60: rom = 20'd757690;
      7'd61: rom = 20'd753598;
      7'd62: rom = 20'd749528;
      7'd63: rom = 20'd745480;
      7'd64: rom = 20'd741454;
      7'd65: rom = 20'd737450;
      7'd66: rom = 20'd733467;
      7'd67: rom = 20'd729506;
      7'd68: rom = 20'd725567;
      7'd69: rom = 20'd721648;
      7'd70: rom = 20'd717751;
      7'd71: rom = 20'd713874;
      7'd72: rom = 20'd710019;
      7'd73: rom = 20'd706185;
      7'd74: rom = 20'd702371;
      7'd75: rom = 20'd698578;
      7'd76: rom = 20'd694805;
      7'd77: rom = 20'd691053;
      7'd78: rom = 20'd687321;
      7'd79: rom = 20'd683609;
      7'd80: rom = 20'd679917;
      7'd81: rom = 20'd676245;
      7'd82: rom = 20'd672593;
      7'd83: rom = 20'd668960;
      7'd84: rom = 20'd665348;
      7'd85: rom = 20'd661754;
      7'd86: rom = 20'd658180;
      7'd87: rom = 20'd654626;
      7'd88: rom = 20'd651091;
      7'd89: rom = 20'd647574;
      7'd90: rom = 20'd644077;
      7'd91: rom = 20'd640599;
      7'd92: rom = 20'd637139;
      7'd93: rom = 20'd633698;
      7'd94: rom = 20'd630276;
      7'd95: rom = 20'd626872;
      7'd96: rom = 20'd623486;
      7'd97: rom = 20'd620119;
      7'd98: rom = 20'd616770;
      7'd99: rom = 20'd613439;
      7'd100: rom = 20'd610126;
      7'd101: rom = 20'd606831;
      7'd102: rom = 20'd603554;
      7'd103: rom = 20'd600295;
      7'd104: rom = 20'd597053;
      7'd105: rom = 20'd593828;
      7'd106: rom = 20'd590621;
      7'd107: rom = 20'd587432;
      7'd108: rom = 20'd584259;
      7'd109: rom = 20'd581104;
      7'd110: rom = 20'd577966;
      7'd111: rom = 20'd574844;
      7'd112: rom = 20'd571740;
      7'd113: rom = 20'd568652;
      7'd114: rom = 20'd565581;
      7'd115: rom = 20'd562526;
      7'd116: rom = 20'd559489;
      7'd117: rom = 20'd556467;
      7'd118: rom = 20'd553462;
      7'd119: rom = 20'd550473;
      7'd120: rom = 20'd547500;
      7'd121: rom = 20'd544543;
      7'd122: rom = 20'd541602;
      7'd123: rom = 20'd538677;
      7'd124: rom = 20'd535768;
      7'd125: rom = 20'd532875;
      7'd126: rom = 20'd529997;
      7'd127: rom = 20'd527135;
      default: rom = 20'd0;
    endcase
  endfunction

  assign y_o = {1'b0, rom(a_i)};

endmodule

`default_nettype wire
