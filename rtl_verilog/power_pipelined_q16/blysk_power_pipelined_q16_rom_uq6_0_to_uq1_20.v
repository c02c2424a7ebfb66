// SPDX-License-Identifier: Apache-2.0
// Read-only memory: y_o = the word at a_i, 0 beyond the last one.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_rom_uq6_0_to_uq1_20 (
    input  wire [5:0] a_i,  // UQ6.0
    output wire [20:0] y_o  // UQ1.20
);

  function [19:0] rom;
    input [5:0] index;
    case (index)
      6'd0: rom = 20'd1048568;
      6'd1: rom = 20'd1041386;
      6'd2: rom = 20'd1034342;
      6'd3: rom = 20'd1027431;
      6'd4: rom = 20'd1020649;
      6'd5: rom = 20'd1013992;
      6'd6: rom = 20'd1007456;
      6'd7: rom = 20'd1001038;
      6'd8: rom = 20'd994733;
      6'd9: rom = 20'd988539;
      6'd10: rom = 20'd982452;
      6'd11: rom = 20'd976468;
      6'd12: rom = 20'd970586;
      6'd13: rom = 20'd964801;
      6'd14: rom = 20'd959112;
      6'd15: rom = 20'd953516;
      6'd16: rom = 20'd948009;
      6'd17: rom = 20'd942590;
      6'd18: rom = 20'd937256;
      6'd19: rom = 20'd932005;
      6'd20: rom = 20'd926834;
      6'd21: rom = 20'd921743;
      6'd22: rom = 20'd916728;
      6'd23: rom = 20'd911787;
      6'd24: rom = 20'd906920;
      6'd25: rom = 20'd902123;
      6'd26: rom = 20'd897396;
      6'd27: rom = 20'd892736;
      6'd28: rom = 20'd888142;
      6'd29: rom = 20'd883612;
      6'd30: rom = 20'd879145;
      6'd31: rom = 20'd874740;
      6'd32: rom = 20'd870394;
      6'd33: rom = 20'd866107;
      6'd34: rom = 20'd861877;
      6'd35: rom = 20'd857703;
      6'd36: rom = 20'd853584;
      6'd37: rom = 20'd849518;
      6'd38: rom = 20'd845504;
      6'd39: rom = 20'd841542;
      6'd40: rom = 20'd837629;
      6'd41: rom = 20'd833766;
      6'd42: rom = 20'd829950;
      6'd43: rom = 20'd826182;
      6'd44: rom = 20'd822459;
      6'd45: rom = 20'd818782;
      6'd46: rom = 20'd815148;
      6'd47: rom = 20'd811558;
      6'd48: rom = 20'd808010;
      6'd49: rom = 20'd804504;
      6'd50: rom = 20'd801039;
      6'd51: rom = 20'd797613;
      6'd52: rom = 20'd794226;
      6'd53: rom = 20'd790878;
      6'd54: rom = 20'd787568;
      6'd55: rom = 20'd784294;
      6'd56: rom = 20'd781057;
      6'd57: rom = 20'd777855;
      6'd58: rom = 20'd774689;
      6'd59: rom = 20'd771556;
      6'd60: rom = 20'd768457;
      6'd61: rom = 20'd765392;
      6'd62: rom = 20'd762358;
      6'd63: rom = 20'd759357;
      default: rom = 20'd0;
    endcase
  endfunction

  assign y_o = {1'b0, rom(a_i)};

endmodule

`default_nettype wire
