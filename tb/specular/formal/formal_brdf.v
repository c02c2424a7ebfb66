// SPDX-License-Identifier: Apache-2.0
// From registers 1 and 2 to the BRDF: the exported device against the reference, both cut at the registers: see
// formal.sh.
`default_nettype none

module formal_brdf #(
    parameter F = 8,
    parameter [F:0] ONE = 1 << F
) (
    input wire [9:0] n,
    input wire [F:0] cos_delta
);

  wire [F:0] brdf, reference_brdf;
  device device (.n(n), .cos_delta(cos_delta), .brdf(brdf));
  reference reference (.n(n), .cos_delta(cos_delta), .brdf(reference_brdf));
  always @* begin
    assume (n <= 1000 && cos_delta <= ONE);
    assert (brdf == reference_brdf);
  end

endmodule

`default_nettype wire
