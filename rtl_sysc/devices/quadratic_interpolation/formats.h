// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/pixel_counter.h"
#include "rtl_sysc/blocks/quantise.h"
#include "rtl_sysc/blocks/start_register.h"
#include "rtl_sysc/formats.h"

namespace blysk {

/// Pixels of a scan line beyond its first one, 0..1023.
using line_length = uq<10, 0>;

/// Nets of the interpolator by forward differences, all with Q::frac fraction bits.
template <class Q>
struct quadratic_interpolation_formats {
  static constexpr int frac = Q::frac;

  using value_in = uq<8, frac>;   // intensity of the first pixel
  using first_in = sq<8, frac>;   // its first difference
  using second_in = sq<0, frac>;  // the second difference, the same for all pixels
  using second = second_in;
  using first = sq<11, frac>;
  using value = sq<21, frac>;

  using control = pixel_counter<line_length>;
  using rg_second = start_register<second_in, second>;
  using rg_first = start_register<first_in, first>;
  using rg_value = start_register<value_in, value>;
  using add_first = add<first, second, first>;
  using add_value = add<value, first, value>;
  using quant = quantise<value, colour, overflow::clamp>;

  /// No net overflows for any legal input: the laws, taken once for each of the longest line's pixels at the ends of the
  /// operands' ranges.
  static constexpr bool no_overflow() {
    using std::int64_t;
    int64_t first_lo = first_in::min;
    int64_t first_hi = first_in::max;
    int64_t value_lo = value_in::min;
    int64_t value_hi = value_in::max;
    bool holds = true;
    for (int64_t pixel = 0; pixel <= line_length::max; ++pixel) {
      value_lo = add_value::law(value_lo, first_lo, int64_t(0));
      value_hi = add_value::law(value_hi, first_hi, int64_t(0));
      first_lo = add_first::law(first_lo, int64_t(second_in::min), int64_t(0));
      first_hi = add_first::law(first_hi, int64_t(second_in::max), int64_t(0));
      holds = holds && fits<first>(first_lo, first_hi) && fits<value>(value_lo, value_hi);
    }
    return holds;
  }
};

}  // namespace blysk
