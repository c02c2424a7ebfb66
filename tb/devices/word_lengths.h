// SPDX-License-Identifier: Apache-2.0
/// Word lengths that a user gives, checked against those that a model has.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "tb/device.h"

namespace blysk {

/// A word length of a model: where it goes, and its range.
struct known_width {
  std::string name;
  int* width;
  int least, most;
};

/// Takes all of them from `bits`.
/// \throws std::invalid_argument for one that is missing, outside its range, or not among those known
inline void take_widths(const word_lengths& bits, std::span<const known_width> known) {
  for (const auto& each : bits) {
    const auto found = std::ranges::find(known, each.first, &known_width::name);
    if (found == known.end()) {
      std::vector<std::string> names;
      for (const known_width& one : known) names.push_back(one.name);
      throw std::invalid_argument(
          fmt::format("word length {} does not exist, expected {}", each.first, fmt::join(names, ", ")));
    }
    if (each.second < found->least || each.second > found->most) {
      throw std::invalid_argument(fmt::format("word length {} {} is outside its range, expected {}..{}",
                                              each.first, each.second, found->least, found->most));
    }
    *found->width = each.second;
  }
  for (const known_width& one : known) {
    if (!bits.contains(one.name))
      throw std::invalid_argument(fmt::format("word length {} is missing", one.name));
  }
}

}  // namespace blysk
