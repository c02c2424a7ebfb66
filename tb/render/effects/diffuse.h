// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/render/effects/fixed.h"

namespace blysk::render {

/// I_l k_d N.L.   [T] (1.2)
/// \param coefficient  UQ8.8
/// \param cosine       UQ1.fraction, 0..2^fraction
/// \return             SQ15.16, to nearest
constexpr std::int32_t diffuse_term(std::int32_t coefficient, std::int64_t cosine, int fraction) {
  return static_cast<std::int32_t>(rescaled(coefficient * cosine, kCoefficientBits + fraction, kSumBits));
}

}  // namespace blysk::render
