// SPDX-License-Identifier: Apache-2.0
// coverage_qF FILE.dat: line and toggle coverage of the exported device under what the regression sends: all n at all
// cosines, up to 12 fraction bits, random inputs and corners beyond, and strobes in every order.
#include <stdexcept>

#include "Vcovered.h"
#include "tb/cosim/strobes.h"
#include "tb/cosim/vectors.h"
#include "tb/cosim/verilated_quadratic.h"
#include "tb/program.h"

namespace {

constexpr int kFraction = BLYSK_FRACTION;

struct device {
  Vcovered top;
  std::int64_t brdf() const { return 0; }
};

int run(int argc, char** argv) {
  using namespace blysk;
  if (argc != 2) throw std::invalid_argument("usage: coverage_qF FILE.dat");
  cosim::verilated_quadratic<device> verilog;
  results out;
  const auto run = [&](const batch& in) { verilog.run(in, out); };
  if constexpr (kFraction <= 12) {
    cosim::for_all_inputs(kFraction, run);
  } else {
    cosim::for_random_inputs(kFraction, 2'000'000, 1, run);
    cosim::for_corner_inputs(kFraction, 64, run);
  }
  cosim::play_strobes(verilog, kFraction, [](const cosim::outputs&) {});
  Verilated::threadContextp()->coveragep()->write(argv[1]);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return blysk::run_program("coverage", [&] { return run(argc, argv); });
}
