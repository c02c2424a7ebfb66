// SPDX-License-Identifier: Apache-2.0
// bench_verilog [PAIRS]: how fast the exported Verilog is, relative to the reference written by hand. Both take the same
// writes in turns; each pair of runs gives a ratio of processor times, so what else the machine does cancels out.
#include <algorithm>
#include <ctime>
#include <random>

#include "tb/cosim/program.h"
#include "tb/cosim/vectors.h"
#include "tb/cosim/verilator_engine.h"
#include "tb/device.h"

namespace {

using namespace blysk;

double seconds(cosim::verilator_engine& verilog, const batch& in) {
  results out;
  out.resize(in.size());
  const std::clock_t start = std::clock();
  verilog.run(in, out);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double quantile(std::vector<double> values, double part) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

void measure(const std::string& format, std::uint64_t pairs) {
  constexpr std::uint64_t kWrites = 400'000;
  device_options options;
  options.format = format;
  batch in;
  cosim::for_random_inputs(fraction_bits(options), kWrites, 1, [&](const batch& part) {
    for (std::size_t i = 0; i < part.size(); ++i) {
      cosim::append(in, part.n[i], part.cos_delta[i], part.red_ks[i], part.green_ks[i], part.blue_ks[i]);
    }
  });
  std::mt19937 random(1);
  std::vector<double> ratios, rates;
  for (std::uint64_t pair = 0; pair < pairs; ++pair) {
    // Either is up to a sixth slower at some addresses, so every pair has its own.
    const std::vector<char> one(16 * (random() % 256));
    const auto exported = cosim::make_verilator(options);
    const std::vector<char> other(16 * (random() % 256));
    const auto reference = cosim::make_reference(format);
    const bool exported_first = pair % 2 == 0;
    const double first = seconds(exported_first ? *exported : *reference, in);
    const double second = seconds(exported_first ? *reference : *exported, in);
    ratios.push_back(exported_first ? second / first : first / second);
    rates.push_back(static_cast<double>(kWrites) / (exported_first ? first : second));
  }
  fmt::print(
      "{}: exported {:.2f} M writes/s; speed relative to the reference {:.3f} (quartiles {:.3f}, {:.3f})\n",
      format, quantile(rates, 0.5) / 1e6, quantile(ratios, 0.5), quantile(ratios, 0.25),
      quantile(ratios, 0.75));
}

}  // namespace

int main(int argc, char** argv) {
  return cosim::program([&] {
    if (argc > 2) throw std::invalid_argument("usage: bench_verilog [PAIRS]");
    const std::uint64_t pairs = argc == 2 ? cosim::positive("PAIRS", argv[1]) : 101;
    for (const char* format : {"q8", "q12"}) measure(format, pairs);
    return 0;
  });
}
