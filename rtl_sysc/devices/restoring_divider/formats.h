// SPDX-License-Identifier: Apache-2.0
/// The formats of the nets of restoring_divider.
#pragma once

#include "rtl_sysc/blocks/divide_steps.h"
#include "rtl_sysc/blocks/magnitude.h"
#include "rtl_sysc/blocks/move_point.h"
#include "rtl_sysc/blocks/pipe.h"
#include "rtl_sysc/blocks/sequencer.h"
#include "rtl_sysc/blocks/sign.h"
#include "rtl_sysc/blocks/with_sign.h"
#include "rtl_sysc/devices/shift_divider/formats.h"

namespace blysk {

/// Nets of restoring_divider. Q::frac is the number of fraction bits of the increment, as many as shift_divider has.
///
/// The divider takes a dividend that is no larger than the divisor, so that |difference| goes in as a fraction, 2^-8 of it,
/// and the quotient comes out by 2^8 too small.
template <class Q>
struct restoring_divider_formats {
  static constexpr int increment_bits = Q::frac;
  static constexpr int places = 8;  // integer bits of |difference|

  using difference = intensity_difference;
  using length = run_length;
  using size = uq<places, 0>;                             // |difference|
  using dividend = uq<0, places>;                         // 2^-8 |difference|
  using quotient = uq<1, places + increment_bits>;        // 2^-8 |difference| / length
  using increment_size = uq<places + 1, increment_bits>;  // |difference| / length
  using increment = sq<places, increment_bits>;

  using sign_of = sign<difference>;
  using mag_difference = magnitude<difference, size>;
  using fraction_of = move_point<size, dividend>;
  using div = divide_steps<dividend, length, quotient>;
  using control = sequencer<div::steps>;
  using whole_of = move_point<quotient, increment_size>;
  using sign_quotient = with_sign<increment_size, increment>;

  /// No net overflows for any legal input: the largest quotient is that of the largest difference by a length of 1.
  static constexpr bool no_overflow() {
    using std::int64_t;
    constexpr int64_t size_hi = mag_difference::law(int64_t(difference::min));
    constexpr int64_t quotient_hi = div::row::law(fraction_of::law(size_hi), int64_t(length::min));
    static_assert(fits<size>(mag_difference::law(int64_t(0)), size_hi));
    static_assert(fits<size>(0, mag_difference::law(int64_t(difference::max))));
    static_assert(fits<dividend>(0, fraction_of::law(size_hi)));
    static_assert(fits<quotient>(0, quotient_hi));
    static_assert(fits<increment_size>(0, whole_of::law(quotient_hi)));
    static_assert(fits<increment>(sign_quotient::law(int64_t(1), quotient_hi),
                                  sign_quotient::law(int64_t(0), quotient_hi)));
    return true;
  }
};

}  // namespace blysk
