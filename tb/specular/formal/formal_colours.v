// SPDX-License-Identifier: Apache-2.0
// Multipliers 12..14 of the exported device against the reference's, both cut at the registers and at the BRDF: see
// formal.sh.
`default_nettype none

module formal_colours #(
    parameter F = 8
) (
    input wire [F:0] brdf,
    input wire [7:0] r_ks, g_ks, b_ks
);

  wire [F+7:0] r_o, g_o, b_o, reference_r_o, reference_g_o, reference_b_o;
  device device (.brdf(brdf), .r_ks(r_ks), .g_ks(g_ks), .b_ks(b_ks), .r_o(r_o), .g_o(g_o), .b_o(b_o));
  reference reference (.brdf(brdf), .r_ks(r_ks), .g_ks(g_ks), .b_ks(b_ks),
                       .r_o(reference_r_o), .g_o(reference_g_o), .b_o(reference_b_o));
  always @* assert (r_o == reference_r_o && g_o == reference_g_o && b_o == reference_b_o);

endmodule

`default_nettype wire
