// SPDX-License-Identifier: Apache-2.0
// sweep_verilog FORMAT [COUNT]: the exported Verilog against the bit-accurate model at every input, or at COUNT random
// ones. Exit 1 if they differ anywhere.
#include "tb/bit/quadratic.h"
#include "tb/cosim/program.h"
#include "tb/cosim/vectors.h"
#include "tb/cosim/verilator_engine.h"
#include "tb/progress.h"

namespace {

int sweep(int argc, char** argv) {
  using namespace blysk;
  if (argc < 2 || argc > 3) throw std::invalid_argument("usage: sweep_verilog FORMAT [COUNT]");
  device_options options;
  options.format = argv[1];
  const int fraction = fraction_bits(options);
  const std::uint64_t count =
      argc == 3 ? cosim::positive("COUNT", argv[2]) : 1000 * ((std::uint64_t{1} << fraction) + 1);
  const auto verilog = cosim::make_verilator(options);
  const auto model = bit::make_quadratic(options);
  results got, expected;
  std::uint64_t compared = 0;
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
      compared += in.size();
      bar.advance(in.size());
    };
    if (argc == 3) {
      cosim::for_random_inputs(fraction, count, 1, compare);
    } else {
      cosim::for_all_inputs(fraction, compare);
    }
  }
  fmt::print("{}: {} of {} writes compared, {} differ\n", options.format, compared, count, differences);
  return compared == count && differences == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return blysk::cosim::program([&] { return sweep(argc, argv); });
}
