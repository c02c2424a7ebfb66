// SPDX-License-Identifier: Apache-2.0
// Straight lines between the words of a table, y_o rounded to nearest.
// device arccos, format q8, 14 digits of the root, table of 17 words, exported from the SystemC model.
`default_nettype none

module blysk_arccos_q8_line_table_uq1_8_to_uq1_13 (
    input  wire [8:0] a_i,  // UQ1.8, codes 0..256
    output wire [13:0] y_o  // UQ1.13
);

  function [13:0] rom;
    input [4:0] index;
    case (index)
      5'd0: rom = 14'd11585;
      5'd1: rom = 14'd11646;
      5'd2: rom = 14'd11709;
      5'd3: rom = 14'd11774;
      5'd4: rom = 14'd11841;
      5'd5: rom = 14'd11910;
      5'd6: rom = 14'd11982;
      5'd7: rom = 14'd12056;
      5'd8: rom = 14'd12132;
      5'd9: rom = 14'd12211;
      5'd10: rom = 14'd12294;
      5'd11: rom = 14'd12379;
      5'd12: rom = 14'd12468;
      5'd13: rom = 14'd12562;
      5'd14: rom = 14'd12659;
      5'd15: rom = 14'd12761;
      5'd16: rom = 14'd12868;
      default: rom = 14'd0;
    endcase
  endfunction

  function [6:0] rom2;
    input [4:0] index2;
    case (index2)
      5'd0: rom2 = 7'd61;
      5'd1: rom2 = 7'd63;
      5'd2: rom2 = 7'd65;
      5'd3: rom2 = 7'd67;
      5'd4: rom2 = 7'd69;
      5'd5: rom2 = 7'd72;
      5'd6: rom2 = 7'd74;
      5'd7: rom2 = 7'd76;
      5'd8: rom2 = 7'd79;
      5'd9: rom2 = 7'd83;
      5'd10: rom2 = 7'd85;
      5'd11: rom2 = 7'd89;
      5'd12: rom2 = 7'd94;
      5'd13: rom2 = 7'd97;
      5'd14: rom2 = 7'd102;
      5'd15: rom2 = 7'd107;
      5'd16: rom2 = 7'd0;
      default: rom2 = 7'd0;
    endcase
  endfunction

  wire [4:0] shifted = a_i[8:4];
  wire [3:0] bits = a_i[3:0] & 4'd15;
  wire [10:0] product = rom2(shifted) * bits;
  wire [10:0] sum = product + 11'd8;
  wire [3:0] unused_sum_low = sum[3:0];  // below the last place of the result

  assign y_o = rom(shifted) + {7'b0, sum[10:4]};

endmodule

`default_nettype wire
