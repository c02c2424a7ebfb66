// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/inverter_bank.h"
#include "rtl_sysc/blocks/line_control.h"
#include "rtl_sysc/blocks/quantise.h"
#include "rtl_sysc/blocks/start_register.h"
#include "rtl_sysc/devices/shift_divider/formats.h"

namespace blysk {

/// Nets of the Gouraud interpolator. Q::frac is the number of shifts, n of [T] (2.18).
template <class Q>
struct gouraud_formats : shift_divider_formats<Q> {
  using base = shift_divider_formats<Q>;

  using inverted = sq<8, 0>;              // ones' complement of the left intensity
  using intensity = sq<10, base::steps>;  // along the line; the error of the increment grows with each pixel

  using control = line_control<run_length, base::steps>;
  using inv_left = inverter_bank<colour, inverted>;
  using add_difference = add<colour, inverted, intensity_difference>;
  using add_pixel = add<intensity, typename base::increment, intensity>;
  using rg_pixel = start_register<colour, intensity>;
  using quant_pixel = quantise<intensity, colour, overflow::clamp>;

  /// No net overflows for any legal input: after the last pixel's addition the intensity is
  /// left + (k + 1) difference (1/k rounded).
  static constexpr bool no_overflow() {
    using std::int64_t;
    static_assert(base::no_overflow());
    static_assert(fits<inverted>(inv_left::law(int64_t(colour::max)), inv_left::law(int64_t(0))));
    static_assert(fits<intensity_difference>(
        add_difference::law(int64_t(0), inv_left::law(int64_t(colour::max)), int64_t(1)),
        add_difference::law(int64_t(colour::max), inv_left::law(int64_t(0)), int64_t(1))));
    int64_t largest = 0;  // (k + 1) (1/k rounded)
    for (std::size_t k = 1; k <= run_length::max; ++k) {
      const int64_t sum = (int64_t(k) + 1) * reciprocal_words<base::steps>::words[0][k];
      if (sum > largest) largest = sum;
    }
    return fits<intensity>(-int64_t(colour::max) * largest,
                           int64_t(colour::max) * largest + (int64_t(colour::max) << base::steps));
  }
};

}  // namespace blysk
