// SPDX-License-Identifier: Apache-2.0
// The device of UA 60553 in a SystemC bench of one's own: one write, and its results.
#include <cstdio>
#include <systemc>

#include "rtl_sysc/devices/quadratic/quadratic.h"

using namespace sc_core;
using formats = blysk::quadratic_formats<blysk::q8, blysk::negative_lobe::clamped>;

int sc_main(int, char**) {
  blysk::quadratic<formats> device("device", blysk::derived_line(formats::coefficient_bits));
  sc_clock clk("clk", 10, SC_NS);
  sc_signal<bool> rst_n("rst_n"), strobe("strobe"), valid("valid");
  sc_signal<formats::n::raw_t> n("n");
  sc_signal<formats::cos_delta::raw_t> cos("cos");
  sc_signal<blysk::colour::raw_t> colour("colour");
  sc_signal<formats::out::raw_t> red("red"), green("green"), blue("blue");
  device(clk, rst_n, n, strobe, cos, strobe, colour, strobe, colour, strobe, colour, strobe, red, green, blue,
         valid);

  sc_start(11, SC_NS);  // reset
  rst_n = true;
  n = 10;
  cos = 253;  // 0.988
  colour = 200;
  strobe = true;
  sc_start(10, SC_NS);  // registers 1, 3, 4, 5
  strobe = false;
  sc_start(10, SC_NS);  // register 2, by the strobe's trailing edge
  std::printf("%.10g\n", red.read().to_int() / 256.0);
  return 0;
}
