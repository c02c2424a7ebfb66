// SPDX-License-Identifier: Apache-2.0
// Puts rows into a mapped device and records the nets of its blocks while it computes ROWS of them. writes.txt has a line
// "n cos r g b" of decimal codes for each row; the first WARM are not recorded. Prints the results, "red green blue" in
// decimal, and at the end "ROWS results in N cycles". The macros are the widths, half the clock's period in ps, PIPELINED for
// a device with start and valid, and MORE, the cycles that one with strobes takes beyond the two of a write.
// +sdf=FILE annotates the cells, +vcd=FILE is what is recorded.
`timescale 1ps / 1ps

module energy;
  reg clk = 1, rst_n = 0, level = 0, trailing = 0;
  reg [9:0] n = 0, next_n;
  reg [`COS_BITS-1:0] cos = 0, next_cos;
  reg [7:0] r = 0, g = 0, b = 0, next_r, next_g, next_b;
  wire [`OUT_BITS-1:0] red, green, blue;
  wire valid;

`ifdef PIPELINED
  mapped dut (
      .clk(clk), .rst_n(rst_n), .n_i(n), .cos_i(cos), .r_i(r), .g_i(g), .b_i(b), .start_i(level), .stall_i(1'b0),
      .ready_o(), .r_o(red), .g_o(green), .b_o(blue), .valid_o(valid)
  );
`else
  mapped dut (
      .clk(clk), .rst_n(rst_n), .n_i(n), .n_we_i(level), .cos_i(cos), .cos_we_i(trailing),
      .r_i(r), .r_we_i(level), .g_i(g), .g_we_i(level), .b_i(b), .b_we_i(level),
      .r_o(red), .g_o(green), .b_o(blue), .valid_o(valid)
  );
`endif

  always #`HALF clk = ~clk;

  integer file, fields, row = 0, more, cycles = 0;
  reg is_recorded = 0;
  reg [8*256-1:0] sdf, vcd;

  always @(posedge clk) if (is_recorded) cycles = cycles + 1;

`ifdef PIPELINED
  always @(negedge clk) if (rst_n && valid) $display("%0d %0d %0d", red, green, blue);
`else
  always @(posedge valid) if (row > 0) $display("%0d %0d %0d", red, green, blue);
`endif

  initial if ($value$plusargs("sdf=%s", sdf)) $sdf_annotate(sdf, dut.device);

  // At a falling edge of clk: a row begins or the last one ends.
  task take;
    begin
      if (row == `WARM) begin
        if ($value$plusargs("vcd=%s", vcd)) begin
          $dumpfile(vcd);
          $dumpvars(2, dut.device);
        end
        is_recorded = 1;
      end
      if (row == `WARM + `ROWS) begin
        if ($value$plusargs("vcd=%s", vcd)) $dumpoff;
        is_recorded = 0;
      end
      row = row + 1;
    end
  endtask

  initial begin
    file = $fopen("writes.txt", "r");
    repeat (2) @(negedge clk);
    rst_n = 1;
    fields = $fscanf(file, "%d %d %d %d %d", next_n, next_cos, next_r, next_g, next_b);
    while (fields == 5) begin
`ifdef PIPELINED
      @(negedge clk) take;
      {n, cos, r, g, b} = {next_n, next_cos, next_r, next_g, next_b};
      level = 1;
`else
      @(negedge clk) take;
      level = 0;
      cos = next_cos;
      trailing = 1;
      @(negedge clk) trailing = 0;
      {n, r, g, b} = {next_n, next_r, next_g, next_b};
      level = 1;
      for (more = 0; more < `MORE; more = more + 1) @(negedge clk) level = 0;
`endif
      fields = $fscanf(file, "%d %d %d %d %d", next_n, next_cos, next_r, next_g, next_b);
    end
    $display("%0d results in %0d cycles", `ROWS, cycles);
    $finish(0);
  end
endmodule
