// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/render/effects/fixed.h"

namespace blysk::render {

/// I_a k_a, and the colour of a surface that shines by itself.   [T] (1.2)
/// \param coefficient  UQ8.8
/// \return             SQ15.16, exact
constexpr std::int32_t ambient_term(std::int32_t coefficient) {
  return static_cast<std::int32_t>(rescaled(coefficient, kCoefficientBits, kSumBits));
}

}  // namespace blysk::render
