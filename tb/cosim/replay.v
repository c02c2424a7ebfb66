// SPDX-License-Identifier: Apache-2.0
// Replays writes and their expected colours on the exported device in Icarus. DEVICE names its module; the file named
// by +vectors has a line "n cos r g b red green blue" of decimal numbers per write. +stuck25 and +stuck29 break the
// device, so that the bench can be seen to notice.
`timescale 1ns / 1ps

module replay;
  parameter F = 8;

  reg clk = 1, rst_n = 0, strobe = 0, strobe17 = 0;
  reg [9:0] n;
  reg [F:0] cosine;
  reg [7:0] r, g, b;
  wire [F+7:0] red, green, blue;
  wire valid;

  `DEVICE device (
      .clk(clk), .rst_n(rst_n), .n_i(n), .n_we_i(strobe), .cos_i(cosine), .cos_we_i(strobe17),
      .r_i(r), .r_we_i(strobe), .g_i(g), .g_we_i(strobe), .b_i(b), .b_we_i(strobe),
      .r_o(red), .g_o(green), .b_o(blue), .valid_o(valid)
  );

  always #5 clk = ~clk;

  integer file, fields, writes = 0, compared = 0, failures = 0;
  reg [8*1024-1:0] path;
  reg [F+7:0] expected_red, expected_green, expected_blue;
  reg [9:0] next_n;
  reg [F:0] next_cosine;
  reg [7:0] next_r, next_g, next_b;
  reg [F+7:0] next_red, next_green, next_blue;

  // 25..27 belong to the write before when 29 rises.
  always @(posedge valid)
    if (writes > 0) begin
      compared = compared + 1;
      if ({red, green, blue} !== {expected_red, expected_green, expected_blue}) begin
        failures = failures + 1;
        $display("write %0d, n = %0d, cos = %0d: got %0d %0d %0d, expected %0d %0d %0d", writes, n, cosine, red, green,
                 blue, expected_red, expected_green, expected_blue);
      end
    end

  initial begin
    if ($test$plusargs("stuck25")) force device.r_o = 0;
    if ($test$plusargs("stuck29")) force device.valid_o = 0;
  end

  task read_vector;
    fields = $fscanf(file, "%d %d %d %d %d %d %d %d", next_n, next_cosine, next_r, next_g, next_b, next_red,
                     next_green, next_blue);
  endtask

  initial begin
    if (!$value$plusargs("vectors=%s", path)) $finish(0);
    file = $fopen(path, "r");
    repeat (2) @(negedge clk);
    rst_n = 1;
    read_vector;
    while (fields == 8) begin
      @(negedge clk) strobe = 0;
      cosine = next_cosine;
      strobe17 = 1;
      @(negedge clk) strobe17 = 0;
      {n, r, g, b} = {next_n, next_r, next_g, next_b};
      {expected_red, expected_green, expected_blue} = {next_red, next_green, next_blue};
      strobe = 1;
      writes = writes + 1;
      read_vector;
    end
    @(negedge clk) strobe17 = 1;
    @(posedge clk) $display("%0d writes replayed, %0d compared, %0d differ", writes, compared, failures);
    $finish(0);
  end
endmodule
