// SPDX-License-Identifier: Apache-2.0
// Writes a second through the exported Verilog and through the reference written by hand, taken in turns.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "tb/cosim/vectors.h"
#include "tb/cosim/verilator_engine.h"
#include "tb/device.h"

int main() {
  using namespace blysk;
  using clock = std::chrono::steady_clock;
  constexpr int kRounds = 21;
  constexpr std::uint64_t kWrites = 200'000;
  for (const char* format : {"q8", "q12"}) {
    device_options options;
    options.format = format;
    const std::unique_ptr<cosim::verilator_engine> engines[] = {cosim::make_verilator(options),
                                                                cosim::make_reference(format)};
    std::vector<double> rates[2];
    batch in;
    cosim::for_random_inputs(fraction_bits(options), kWrites, 1, [&](const batch& part) {
      for (std::size_t i = 0; i < part.size(); ++i) {
        cosim::append(in, part.n[i], part.cos_delta[i], part.red_ks[i], part.green_ks[i], part.blue_ks[i]);
      }
    });
    results out;
    for (int round = 0; round < kRounds; ++round) {
      for (int which = 0; which < 2; ++which) {
        const auto start = clock::now();
        engines[which]->run(in, out);
        rates[which].push_back(kWrites / std::chrono::duration<double>(clock::now() - start).count());
      }
    }
    for (auto& rate : rates) std::ranges::sort(rate);
    const double exported = rates[0][kRounds / 2];
    const double reference = rates[1][kRounds / 2];
    fmt::print("{}: exported {:.2f} M writes/s, by hand {:.2f} M writes/s, ratio {:.2f} (medians of {})\n",
               format, exported / 1e6, reference / 1e6, exported / reference, kRounds);
  }
  return 0;
}
