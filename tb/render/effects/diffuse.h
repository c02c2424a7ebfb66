// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/render/effects/fixed.h"

namespace blysk::render {

/// I_l k_d N.L.   [T] (1.2)
/// \param coefficient  UQ8.8
/// \param cosine       UQ1.fraction, 0..2^fraction
/// \param fraction     8 and up, as the formats have it
/// \return             16 fraction bits, to nearest
constexpr std::int64_t diffuse_term(std::int64_t coefficient, std::int64_t cosine, int fraction) {
  return law::mul(coefficient, cosine, kCoefficientBits + fraction - kSumBits);
}

}  // namespace blysk::render
