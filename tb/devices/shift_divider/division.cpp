// SPDX-License-Identifier: Apache-2.0
#include "tb/devices/shift_divider/division.h"

#include <fmt/format.h>

#include <stdexcept>

namespace blysk::shift_divider_device {

int steps_of(const word_lengths& bits) {
  constexpr int kMostSteps = 48;
  for (const auto& [name, width] : bits) {
    if (name != "steps")
      throw std::invalid_argument(fmt::format("word length {} does not exist, expected steps", name));
    if (width < 1 || width > kMostSteps)
      throw std::invalid_argument(
          fmt::format("word length steps {} is outside its range, expected 1..{}", width, kMostSteps));
  }
  if (bits.empty()) throw std::invalid_argument("word length steps is missing");
  return bits.at("steps");
}

std::vector<std::int64_t> powers_of_two() {
  std::vector<std::int64_t> codes;
  for (std::int64_t k = 2; k <= run_length::max; k *= 2) codes.push_back(k);
  return codes;
}

}  // namespace blysk::shift_divider_device
