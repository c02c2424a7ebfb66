// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/render/effects/fixed.h"

namespace blysk::render {

/// I_a k_a, and the colour of a surface that shines by itself.   [T] (1.2)
/// \param coefficient  UQ8.8
/// \return             16 fraction bits, exact
constexpr std::int64_t ambient_term(std::int64_t coefficient) {
  return law::rescale(coefficient, kCoefficientBits, kSumBits);
}

}  // namespace blysk::render
