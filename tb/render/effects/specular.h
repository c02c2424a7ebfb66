// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/render/effects/fixed.h"

namespace blysk::render {

/// I_l k_s lobe(n, N.H), as a device computes it.   [P] fig. 1, outputs 25, 26, 27
/// \param result    of a colour output: an integer with `fraction` bits
/// \return          SQ15.16, to nearest
constexpr std::int32_t specular_term(std::int64_t result, int fraction) {
  return static_cast<std::int32_t>(rescaled(result, fraction, kSumBits));
}

/// The same of a formula's result in double.
inline std::int32_t specular_term(double result) {
  return static_cast<std::int32_t>(std::lround(std::ldexp(result, kSumBits)));
}

}  // namespace blysk::render
