// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/render/effects/fixed.h"

namespace blysk::render {

/// I_l k_s lobe(n, N.H), as a device computes it.   [P] fig. 1, outputs 25, 26, 27
/// \param result    of a colour output: an integer with `fraction` bits
/// \return          16 fraction bits, to nearest
constexpr std::int64_t specular_term(std::int64_t result, int fraction) {
  return law::rescale(result, fraction, kSumBits);
}

/// The same of a formula's result in double.
inline std::int64_t specular_term(double result) {
  return std::llround(std::ldexp(result, kSumBits));
}

}  // namespace blysk::render
