// SPDX-License-Identifier: Apache-2.0
// bench_verilog DEVICE [PAIRS]: how fast the exported Verilog is, relative to the reference written by hand. Both take the
// same writes in turns; each pair of runs gives a ratio of processor times, so what else the machine does cancels out.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <random>
#include <stdexcept>

#include "tb/cosim/reference.h"
#include "tb/inputs.h"
#include "tb/program.h"

namespace {

using namespace blysk;

double seconds(cosim::verilator_engine& verilog, const columns& in, columns& out) {
  const std::clock_t start = std::clock();
  verilog.run(in, out);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double quantile(std::vector<double> values, double part) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

columns random_writes(const selection& asked, std::size_t count) {
  columns all(asked.of().ports(asked), port::role::data);
  all.resize(count);
  std::size_t first = 0;
  for_random_inputs(asked, count, 1, [&](const columns& part) {
    for (std::size_t i = 0; i < part.width(); ++i) {
      for (std::size_t row = 0; row < part.size(); ++row) all[i].set(first + row, part[i].get(row));
    }
    first += part.size();
  });
  return all;
}

void measure(const selection& asked, std::uint64_t pairs) {
  constexpr std::size_t kWrites = 400'000;
  const columns in = random_writes(asked, kWrites);
  columns out(asked.of().ports(asked), port::role::result);
  out.resize(kWrites);
  std::mt19937 random(1);
  std::vector<double> ratios, rates;
  for (std::uint64_t pair = 0; pair < pairs; ++pair) {
    // Either is up to a sixth slower at some addresses, so every pair has its own.
    const std::vector<char> one(16 * (random() % 256));
    const auto exported = cosim::make_verilator(asked);
    const std::vector<char> other(16 * (random() % 256));
    const auto reference = cosim::make_reference(asked);
    if (reference == nullptr)
      throw std::invalid_argument(asked.text() + " has no reference, expected a device with one");
    const bool exported_first = pair % 2 == 0;
    const double first = seconds(exported_first ? *exported : *reference, in, out);
    const double second = seconds(exported_first ? *reference : *exported, in, out);
    ratios.push_back(exported_first ? second / first : first / second);
    rates.push_back(static_cast<double>(kWrites) / (exported_first ? first : second));
  }
  fmt::print(
      "{}: exported {:.2f} M writes/s; speed relative to the reference {:.3f} (quartiles {:.3f}, {:.3f})\n",
      asked.format(), quantile(rates, 0.5) / 1e6, quantile(ratios, 0.5), quantile(ratios, 0.25),
      quantile(ratios, 0.75));
}

}  // namespace

int main(int argc, char** argv) {
  std::string device;
  std::string pairs = "101";
  return run_program(
      argc, argv, "Speed of the exported Verilog relative to the reference written by hand",
      [&](CLI::App& program) {
        program.add_option("DEVICE", device, "name of a device")->required();
        program.add_option("PAIRS", pairs, "pairs of runs")->capture_default_str();
      },
      [&] {
        for (const char* format : {"q8", "q12"}) measure(choose(device, format), positive("PAIRS", pairs));
        return 0;
      });
}
