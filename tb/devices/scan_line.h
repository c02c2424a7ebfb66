// SPDX-License-Identifier: Apache-2.0
/// What devices that draw scan lines have in common: the length in the first column, both ends included.
#pragma once

#include <cstdint>

#include "tb/columns.h"

namespace blysk::scan_line {

inline constexpr std::size_t kLength = 0;
inline constexpr std::size_t kChannels = 3;

inline std::int64_t pixels_of(const columns& in, std::size_t row) {
  return in[kLength].get(row) + 1;
}

inline std::size_t pixels_of_all(const columns& in) {
  std::int64_t sum = 0;
  for (std::size_t row = 0; row < in.size(); ++row) sum += pixels_of(in, row);
  return static_cast<std::size_t>(sum);
}

/// Calls draw(row, channel, first pixel, pixels) for each channel of each line, after `out` has room for all pixels.
template <class Draw>
void for_channels(const columns& in, columns& out, Draw draw) {
  out.resize(pixels_of_all(in));
  std::size_t first = 0;
  for (std::size_t row = 0; row < in.size(); ++row) {
    const auto pixels = static_cast<std::size_t>(pixels_of(in, row));
    for (std::size_t channel = 0; channel < kChannels; ++channel) draw(row, channel, first, pixels);
    first += pixels;
  }
}

}  // namespace blysk::scan_line
