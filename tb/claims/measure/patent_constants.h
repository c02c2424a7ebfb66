// SPDX-License-Identifier: Apache-2.0
/// Readings of the constant of block 6 of [P].
#pragma once

#include <array>
#include <string_view>

namespace blysk::claims {

/// As bits behind the point.
inline constexpr std::array<std::string_view, 3> kConstants{"11001001", "110010", "110011"};

constexpr double fixed_point(std::string_view bits) {
  double result = 0;
  double weight = 1;
  for (const char bit : bits) result += (weight /= 2) * (bit == '1');
  return result;
}

}  // namespace blysk::claims
