// SPDX-License-Identifier: Apache-2.0
// coverage_verilog FILE.dat: line and toggle coverage of the exported q8 device under what the regression sends: all n at all
// cosines, and strobes in every order.
#include <cstdio>

#include "Vcovered.h"
#include "tb/cosim/strobes.h"
#include "tb/cosim/vectors.h"
#include "tb/cosim/verilated_quadratic.h"

namespace {

struct device {
  Vcovered top;
  std::int64_t brdf() const { return 0; }
};

}  // namespace

int main(int argc, char** argv) {
  using namespace blysk;
  if (argc != 2) {
    std::fputs("usage: coverage_verilog FILE.dat\n", stderr);
    return 2;
  }
  cosim::verilated_quadratic<device> verilog;
  results out;
  cosim::for_all_inputs(8, [&](const batch& in) { verilog.run(in, out); });
  cosim::strobe_sequence strobes(8);
  cosim::pins values;
  for (int cycle = 0; cycle < 20'000; ++cycle) {
    values = strobes.next(values);
    for (const bool clk : {false, true}) {
      values.clk = clk;
      verilog.apply(values);
    }
  }
  Verilated::threadContextp()->coveragep()->write(argv[1]);
  return 0;
}
