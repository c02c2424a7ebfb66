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
  cosim::play_strobes(verilog, 8, [](const cosim::outputs&) {});
  Verilated::threadContextp()->coveragep()->write(argv[1]);
  return 0;
}
