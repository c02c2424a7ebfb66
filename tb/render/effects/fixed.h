// SPDX-License-Identifier: Apache-2.0
/// Formats of the effects, and the laws that their blocks in SystemC have. Intensities are in units of 1/255 of full light,
/// as on the colour ports of the devices.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "rtl_sysc/blocks/law.h"

namespace blysk::render {

inline constexpr int kCoefficientBits = 8;  ///< fraction bits of a coefficient, UQ8.8
inline constexpr int kSumBits = 16;         ///< fraction bits of a term and of a sum of effects

/// Coefficients by channel, UQ8.8.
using coefficient_rgb = std::array<std::int32_t, 3>;

/// Sum of effects by channel, SQ47.16.
using sum_rgb = std::array<std::int64_t, 3>;
inline constexpr std::size_t kMostLights = 64;

/// Bits before the point of the largest term: of any device's colour output, with or without clamp.
inline constexpr int kTermIntegerBits = 39;
inline constexpr int kColourIntegerBits = 8;  ///< of a colour output that is limited to 255
static_assert((std::int64_t{kMostLights} + 1) * 2 <= std::int64_t{1} << (63 - kTermIntegerBits - kSumBits),
              "two terms of each light and the ambient one fit into a sum");

/// Coefficient of an intensity in [0, 1], to nearest: 0..65280.
inline std::int32_t coefficient_code(double intensity) {
  return static_cast<std::int32_t>(
      std::lround(std::ldexp(255 * std::clamp(intensity, 0.0, 1.0), kCoefficientBits)));
}

/// The code of a cosine in [0, 1] with `fraction` bits, to nearest: 0..2^fraction.
inline std::int64_t cosine_code(double cosine, int fraction) {
  return std::llround(std::ldexp(cosine, fraction));
}

}  // namespace blysk::render
