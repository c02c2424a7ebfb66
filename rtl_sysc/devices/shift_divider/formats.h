// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/digit_register.h"
#include "rtl_sysc/blocks/rom.h"
#include "rtl_sysc/blocks/sequencer.h"
#include "rtl_sysc/blocks/shift_register.h"
#include "rtl_sysc/blocks/sum_register.h"
#include "rtl_sysc/devices/word_arithmetic.h"
#include "rtl_sysc/formats.h"

#include <array>

namespace blysk {

/// Difference of two intensities, -255..255.
struct intensity_difference : sq<8, 0> {
  static constexpr std::int64_t min = -255;
  static constexpr std::int64_t max = 255;
};

/// Pixels of a scan line between two edges, 1..1023.
struct run_length : uq<10, 0> {
  static constexpr std::int64_t min = 1;
};

/// 1/k for each run length k with `Steps` binary places, rounded to nearest (spec erratum E14): the digits i_j of [T]
/// (2.18), and i_0 for k = 1. Run length 0, which is not legal, has 0.
template <int Steps>
struct reciprocal_words {
  using memory = std::array<std::int64_t, 1024>;

  static constexpr memory make() {
    memory all{};
    for (std::size_t k = 1; k < all.size(); ++k) all[k] = rounded_ratio(1, k, Steps);
    return all;
  }

  static constexpr std::array<memory, 1> words{make()};
};

/// Nets of [T] fig. 2.13. Q::frac is the number of shifts, n of (2.18).
template <class Q>
struct shift_divider_formats {
  static constexpr int steps = Q::frac;

  using difference = intensity_difference;
  using length = run_length;
  using digits = unit<steps>;      // 1/k
  using shifted = sq<7, steps>;    // the difference times 2^-1, 2^-2, ...
  using increment = sq<8, steps>;  // what is accumulated

  using rom_digits = rom<length, digits, reciprocal_words<steps>>;
  using rg_digits = digit_register<digits>;
  using rg_shift = shift_register<difference, shifted>;
  using add_sum = add<increment, shifted, increment>;
  using rg_sum = sum_register<difference, increment>;

  /// No net overflows, and no bit that counts is lost, for any legal input: after `steps` shifts the last place of the
  /// difference has the weight 2^-steps, and the largest sum is that of i_0 alone.
  static constexpr bool no_overflow() {
    using std::int64_t;
    constexpr int64_t largest = rg_shift::law(int64_t(1), int64_t(difference::max), int64_t(0));
    constexpr int64_t smallest = rg_shift::law(int64_t(1), int64_t(difference::min), int64_t(0));
    static_assert(smallest <= largest && shifted::min <= smallest && largest <= shifted::max);
    static_assert(fits<digits>(0, reciprocal_words<steps>::words[0][1]));
    // The digits of k = 1 are 1.00..., those of k >= 2 at most 0.1000...
    constexpr int64_t one_hi = rg_sum::law(int64_t(1), int64_t(1), int64_t(difference::max), int64_t(0));
    constexpr int64_t one_lo = rg_sum::law(int64_t(1), int64_t(1), int64_t(difference::min), int64_t(0));
    static_assert(fits<increment>(one_lo, one_hi));
    static_assert(reciprocal_words<steps>::words[0][2] <= digits::max / 2);
    return true;
  }
};

}  // namespace blysk
