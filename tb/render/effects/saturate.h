// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/render/effects/fixed.h"

namespace blysk::render {

/// A channel of the picture: the sum of the effects, saturated to 0..255.   [T] listing A, calcColor
/// \param sum  16 fraction bits
/// \return     16 fraction bits, 0..255
constexpr std::int64_t saturated(std::int64_t sum) {
  return law::clamp(sum, std::int64_t{0}, std::int64_t{255} << kSumBits);
}

/// To nearest, ties up.
/// \param sum  16 fraction bits, saturated
constexpr std::uint8_t channel_of(std::int64_t sum) {
  return static_cast<std::uint8_t>(law::round_off(sum, kSumBits));
}

}  // namespace blysk::render
