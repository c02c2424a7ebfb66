// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/render/effects/fixed.h"

namespace blysk::render {

/// A channel of the picture: the sum of the effects, saturated to 0..255.   [T] listing A, calcColor
/// \param sum  SQ15.16
/// \return     SQ15.16, 0..255
constexpr std::int32_t saturated(std::int32_t sum) {
  return std::clamp(sum, std::int32_t{0}, std::int32_t{255} << kSumBits);
}

/// To nearest, ties up.
/// \param sum  SQ15.16, saturated
constexpr std::uint8_t channel_of(std::int32_t sum) {
  return static_cast<std::uint8_t>(rescaled(sum, kSumBits, 0));
}

}  // namespace blysk::render
