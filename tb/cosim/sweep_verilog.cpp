// SPDX-License-Identifier: Apache-2.0
// sweep_verilog FORMAT [COUNT]: the exported Verilog against the bit-accurate model at every input, or at COUNT random ones.
// Exit 1 at the first difference.
#include <fmt/format.h>

#include "tb/bit/quadratic.h"
#include "tb/cosim/vectors.h"
#include "tb/cosim/verilator_engine.h"
#include "tb/progress.h"

int main(int argc, char** argv) {
  using namespace blysk;
  if (argc < 2 || argc > 3) {
    fmt::print(stderr, "usage: sweep_verilog FORMAT [COUNT]\n");
    return 2;
  }
  device_options options;
  options.format = argv[1];
  const int fraction = fraction_bits(options);
  const std::uint64_t count = argc == 3 ? std::stoull(argv[2]) : 1000 * ((std::uint64_t{1} << fraction) + 1);
  const auto verilog = cosim::make_verilator(options);
  const auto model = bit::make_quadratic(options);
  results got, expected;
  std::uint64_t differences = 0;
  {
    progress bar(options.format, count);
    const auto compare = [&](const batch& in) {
      verilog->run(in, got);
      model->run(in, expected);
      for (std::size_t i = 0; i < in.size(); ++i) {
        differences += got.brdf[i] != expected.brdf[i] || got.red[i] != expected.red[i] ||
                       got.green[i] != expected.green[i] || got.blue[i] != expected.blue[i];
      }
      bar.advance(in.size());
    };
    if (argc == 3) {
      cosim::for_random_inputs(fraction, count, 1, compare);
    } else {
      cosim::for_all_inputs(fraction, compare);
    }
  }
  fmt::print("{}: {} writes, {} differ\n", options.format, count, differences);
  return differences == 0 ? 0 : 1;
}
