// SPDX-License-Identifier: Apache-2.0
// What yosys proves of the exported lighting unit: see formal.sh.
`default_nettype none

module formal #(
    parameter F = 8
) (
    input wire clk,
    input wire rst_n,
    input wire [F:0] nl_i,
    input wire first_i,
    input wire [15:0] ar_i, ag_i, ab_i, dr_i, dg_i, db_i,
    input wire [F+7:0] sr_i, sg_i, sb_i,
    input wire start_i,
    input wire stall_i
);

  wire [23:0] r_sum_o, g_sum_o, b_sum_o, reference_r_sum_o, reference_g_sum_o, reference_b_sum_o;
  wire [7:0] r_o, g_o, b_o, reference_r_o, reference_g_o, reference_b_o;
  wire ready_o, valid_o, reference_ready_o, reference_valid_o;

  device device (
      .clk(clk), .rst_n(rst_n), .nl_i(nl_i), .first_i(first_i), .ar_i(ar_i), .ag_i(ag_i), .ab_i(ab_i),
      .dr_i(dr_i), .dg_i(dg_i), .db_i(db_i), .sr_i(sr_i), .sg_i(sg_i), .sb_i(sb_i),
      .start_i(start_i), .stall_i(stall_i), .ready_o(ready_o), .r_sum_o(r_sum_o), .g_sum_o(g_sum_o), .b_sum_o(b_sum_o),
      .r_o(r_o), .g_o(g_o), .b_o(b_o), .valid_o(valid_o)
  );
  reference reference (
      .clk(clk), .rst_n(rst_n), .nl_i(nl_i), .first_i(first_i), .ar_i(ar_i), .ag_i(ag_i), .ab_i(ab_i),
      .dr_i(dr_i), .dg_i(dg_i), .db_i(db_i), .sr_i(sr_i), .sg_i(sg_i), .sb_i(sb_i),
      .start_i(start_i), .stall_i(stall_i), .ready_o(reference_ready_o), .r_sum_o(reference_r_sum_o),
      .g_sum_o(reference_g_sum_o), .b_sum_o(reference_b_sum_o), .r_o(reference_r_o), .g_o(reference_g_o),
      .b_o(reference_b_o), .valid_o(reference_valid_o)
  );

  // The host starts with a reset.
  reg started = 0;
  always @(posedge clk) started <= 1;
  always @* assume (started || !rst_n);

  localparam [23:0] MOST = 255 << 16;

  always @* if (started) begin
`ifdef PROVE_EQUAL
    assert (ready_o == reference_ready_o && valid_o == reference_valid_o);
    assert (r_sum_o == reference_r_sum_o && g_sum_o == reference_g_sum_o && b_sum_o == reference_b_sum_o);
    assert (r_o == reference_r_o && g_o == reference_g_o && b_o == reference_b_o);
`endif
`ifdef PROVE_RANGE
    assert (r_sum_o <= MOST && g_sum_o <= MOST && b_sum_o <= MOST);
`endif
  end

`ifdef PROVE_STAND
  // What the last edge of clk saw.
  reg stands = 0;
  reg [23:0] r_before, g_before, b_before;
  always @(posedge clk) begin
    stands <= rst_n && valid_o && stall_i;
    {r_before, g_before, b_before} <= {r_sum_o, g_sum_o, b_sum_o};
  end
  always @* begin
    assert (ready_o == !(valid_o && stall_i));
    if (started && stands) assert (valid_o && r_sum_o == r_before && g_sum_o == g_before && b_sum_o == b_before);
  end
`endif

endmodule

`default_nettype wire
