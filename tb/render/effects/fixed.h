// SPDX-License-Identifier: Apache-2.0
/// Formats of the effects. Intensities are in units of 1/255 of full light, as on the colour ports of the devices.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace blysk::render {

inline constexpr int kCoefficientBits = 8;  ///< fraction bits of a coefficient, UQ8.8
inline constexpr int kSumBits = 16;         ///< fraction bits of a sum of effects, SQ15.16

/// Sum of effects by channel. 64 lights at full intensity are far from its ends.
using sum_rgb = std::array<std::int32_t, 3>;
inline constexpr std::size_t kMostLights = 64;

/// Coefficient of an intensity in [0, 1], to nearest: 0..65280.
inline std::int32_t coefficient_code(double intensity) {
  return static_cast<std::int32_t>(
      std::lround(std::ldexp(255 * std::clamp(intensity, 0.0, 1.0), kCoefficientBits)));
}

/// The number with another count of fraction bits, to nearest, ties up.
constexpr std::int64_t rescaled(std::int64_t raw, int from, int to) {
  if (to >= from) return raw << (to - from);
  const int drop = from - to;
  return (raw + (std::int64_t{1} << (drop - 1))) >> drop;
}

/// The code of a cosine in [0, 1] with `fraction` bits, to nearest: 0..2^fraction.
inline std::int64_t cosine_code(double cosine, int fraction) {
  return std::llround(std::ldexp(cosine, fraction));
}

}  // namespace blysk::render
