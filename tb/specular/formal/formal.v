// SPDX-License-Identifier: Apache-2.0
// What yosys proves of an exported device: see formal.sh. The device's and the reference's nets of interest have
// been made ports (expose). ONE is 1.0 of the cosine, a legal input's largest code.
`default_nettype none

module formal #(
    parameter F = 8,
    parameter [F:0] ONE = 1 << F
) (
    input wire       clk,
    input wire       rst_n,
    input wire [9:0] n_i,
    input wire       n_we_i,
    input wire [F:0] cos_i,
    input wire       cos_we_i,
    input wire [7:0] r_i,
    input wire       r_we_i,
    input wire [7:0] g_i,
    input wire       g_we_i,
    input wire [7:0] b_i,
    input wire       b_we_i
);

  wire [9:0] n;
  wire [F:0] cos_delta, brdf;
  wire [7:0] r_ks, g_ks, b_ks;
  wire [F+7:0] r_o, g_o, b_o;
  wire valid_o;

  device device (
      .clk(clk), .rst_n(rst_n), .n_i(n_i), .n_we_i(n_we_i), .cos_i(cos_i), .cos_we_i(cos_we_i),
      .r_i(r_i), .r_we_i(r_we_i), .g_i(g_i), .g_we_i(g_we_i), .b_i(b_i), .b_we_i(b_we_i),
      .r_o(r_o), .g_o(g_o), .b_o(b_o), .valid_o(valid_o),
      .n(n), .cos_delta(cos_delta), .r_ks(r_ks), .g_ks(g_ks), .b_ks(b_ks), .brdf(brdf)
  );

  // The host keeps to legal cosines, and starts with a reset.
  reg started = 0;
  always @(posedge clk) started <= 1;
  always @* begin
    assume (cos_i <= ONE);
    assume (started || !rst_n);
  end

  // What the last edge of clk saw.
  reg [9:0] n_before;
  reg [F:0] cos_before;
  reg [7:0] r_before, g_before, b_before;
  reg strobe17, quiet = 0;
  always @(posedge clk) begin
    {n_before, cos_before, r_before, g_before, b_before} <= {n, cos_delta, r_ks, g_ks, b_ks};
    strobe17 <= rst_n && cos_we_i;
    quiet <= rst_n && !n_we_i && !r_we_i && !g_we_i && !b_we_i && !(strobe17 && !cos_we_i);
  end

`ifdef PROVE_RANGE
  always @* if (started) begin
    assert (cos_delta <= ONE);
    assert (brdf <= ONE);  // and so no output exceeds its colour, of which it is the product with the BRDF
  end
`endif

`ifdef PROVE_HOLD
  // Outputs are functions of the registers alone, which formal.sh shows on the netlist; so they hold if these do.
  always @* if (started && quiet) begin
    assert (n == n_before && cos_delta == cos_before);
    assert (r_ks == r_before && g_ks == g_before && b_ks == b_before);
  end
`endif

`ifdef PROVE_REGISTERS
  wire [9:0] reference_n;
  wire [F:0] reference_c;
  wire [7:0] reference_red, reference_green, reference_blue;
  wire reference_strobe17, reference_valid_o;

  reference reference (
      .clk(clk), .rst_n(rst_n), .n_i(n_i), .n_we_i(n_we_i), .cos_i(cos_i), .cos_we_i(cos_we_i),
      .r_i(r_i), .r_we_i(r_we_i), .g_i(g_i), .g_we_i(g_we_i), .b_i(b_i), .b_we_i(b_we_i), .valid_o(reference_valid_o),
      .n(reference_n), .cos_delta(reference_c), .r_ks(reference_red), .g_ks(reference_green), .b_ks(reference_blue),
      .strobe17(reference_strobe17)
  );

  always @* if (started) begin
    assert (cos_delta <= ONE);
    assert (strobe17 == reference_strobe17);
    assert (n == reference_n && cos_delta == reference_c);
    assert (r_ks == reference_red && g_ks == reference_green && b_ks == reference_blue);
    assert (valid_o == reference_valid_o);
  end
`endif

endmodule

`default_nettype wire
