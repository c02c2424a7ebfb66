// SPDX-License-Identifier: Apache-2.0
// Writes a device's registers as the bench in SystemC does, and prints of each write how long the outputs changed after the
// clock edge that loaded the registers, ps, and what they became: "ROW PS RED GREEN BLUE" of decimal numbers.
// writes.txt has a line "n cos r g b" of decimal codes for each write. The macros are the widths, half the clock's period in
// ps and the clock cycles that a device takes beyond the two of a write. +sdf=FILE annotates the cells, +vcd=FILE
// records the nets between the blocks.
`timescale 1ps / 1ps

module referee;
  reg clk = 1, rst_n = 0, level = 0, trailing = 0;
  reg [9:0] n = 0, next_n;
  reg [`COS_BITS-1:0] cos = 0, next_cos;
  reg [7:0] r = 0, g = 0, b = 0, next_r, next_g, next_b;
  wire [`OUT_BITS-1:0] red, green, blue;
  wire valid;

  mapped dut (
      .clk(clk), .rst_n(rst_n), .n_i(n), .n_we_i(level), .cos_i(cos), .cos_we_i(trailing),
      .r_i(r), .r_we_i(level), .g_i(g), .g_we_i(level), .b_i(b), .b_we_i(level),
      .r_o(red), .g_o(green), .b_o(blue), .valid_o(valid)
  );

  always #`HALF clk = ~clk;

  integer file, fields, row = 0, more;
  time loaded, changed;
  reg [8*256-1:0] sdf, vcd;

  always @(posedge clk) loaded = $time;
  always @(red or green or blue) changed = $time;

  // The results belong to the write before when valid rises.
  always @(posedge valid)
    if (row > 0) $display("%0d %0d %0d %0d %0d", row, changed > loaded ? changed - loaded : 0, red, green, blue);

  initial if ($value$plusargs("sdf=%s", sdf)) $sdf_annotate(sdf, dut.device);

  initial
    if ($value$plusargs("vcd=%s", vcd)) begin
      $dumpfile(vcd);
      $dumpvars(1, dut.device);
    end

  initial begin
    file = $fopen("writes.txt", "r");
    repeat (2) @(negedge clk);
    rst_n = 1;
    fields = $fscanf(file, "%d %d %d %d %d", next_n, next_cos, next_r, next_g, next_b);
    while (fields == 5) begin
      @(negedge clk) level = 0;
      cos = next_cos;
      trailing = 1;
      @(negedge clk) trailing = 0;
      n = next_n;
      r = next_r;
      g = next_g;
      b = next_b;
      level = 1;
      row = row + 1;
      for (more = 0; more < `MORE; more = more + 1) @(negedge clk) level = 0;
      fields = $fscanf(file, "%d %d %d %d %d", next_n, next_cos, next_r, next_g, next_b);
    end
    @(negedge clk) trailing = 1;
    @(posedge clk) $finish(0);
  end
endmodule
