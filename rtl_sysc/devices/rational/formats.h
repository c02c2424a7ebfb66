// SPDX-License-Identifier: Apache-2.0
/// The formats of the nets of rational.
#pragma once

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/divide.h"
#include "rtl_sysc/blocks/inverter_bank.h"
#include "rtl_sysc/blocks/move_point.h"
#include "rtl_sysc/blocks/mul.h"
#include "rtl_sysc/blocks/one_minus.h"
#include "rtl_sysc/blocks/quantise.h"
#include "rtl_sysc/blocks/rom.h"
#include "rtl_sysc/devices/rational/contents.h"
#include "rtl_sysc/formats.h"

namespace blysk {

/// Where r and d of the lobe (1 - r u)/(1 + d u) come from.
enum class rational_fit {
  best,  ///< read-only memories: for each n the lobe of this form that is closest to c^n for large n
  line   ///< (n + 3)/4 and n - 1: two adders
};

/// Nets of rational for Q::frac fraction bits F of cos(delta). The line's products are exact; the memories' words have F + 1
/// fraction bits, and their products are rounded to F + 3. The quotient has one bit more than the BRDF, so that it is
/// rounded to nearest.
template <class Q, rational_fit Fit>
struct rational_formats {
  static constexpr rational_fit fit = Fit;
  static constexpr bool is_line = Fit == rational_fit::line;
  static constexpr int cos_bits = Q::frac;
  static constexpr int fall_bits = is_line ? 2 : cos_bits + 1;
  static constexpr int rise_bits = is_line ? 0 : cos_bits + 1;
  static constexpr int fall_places = is_line ? 8 : 9;  // integer bits of r
  static constexpr int climb_bits = is_line ? cos_bits : cos_bits + 3;
  static constexpr int part_bits = is_line ? cos_bits + 2 : cos_bits + 3;  // of dividend and divisor

  using n = exponent;
  using cos_delta = unit<cos_bits>;
  using unity = uq<1, 0>;
  using versine = unit<cos_bits>;           // u = 1 - c
  using fall = uq<fall_places, fall_bits>;  // r
  using rise = uq<10, rise_bits>;           // d
  using drop = uq<fall_places, part_bits>;  // r u
  using drop_inverted = sq<fall_places, part_bits>;
  using line = sq<fall_places, part_bits>;  // 1 - r u
  using dividend = unit<part_bits>;         // the line, 0 where it is negative
  using climb = uq<10, climb_bits>;         // d u
  using sum = uq<10, part_bits>;            // 1 + d u
  using divisor = uq<3, part_bits>;         // the sum, limited beyond the root
  using quotient = unit<cos_bits + 1>;
  using brdf = unit<cos_bits>;
  using out = uq<8, cos_bits>;

  // Coefficients by memories.
  using contents = fit_words<cos_bits + 1>;
  using rom_fall = rom<n, fall, contents>;
  using rom_rise = rom<n, rise, contents>;

  // Coefficients on a line.
  using three = uq<2, 0>;
  using minus_one = sq<0, 0>;
  using n_plus_3 = uq<10, 0>;
  using add_fall = add<n, three, n_plus_3>;
  using quarter = move_point<n_plus_3, uq<8, 2>>;
  using add_rise = add<n, minus_one, uq<10, 0>>;

  using sub_cos = one_minus<cos_bits>;
  using mul_fall = mul<fall, versine, drop>;
  using inv_drop = inverter_bank<drop, drop_inverted>;
  using add_line = add<unity, drop_inverted, line>;
  using quant_line = quantise<line, dividend, overflow::clamp>;
  using mul_rise = mul<rise, versine, climb>;
  using add_sum = add<unity, climb, sum>;
  using quant_sum = quantise<sum, divisor, overflow::clamp>;
  using div = divide<dividend, divisor, quotient>;
  using quant = quantise<quotient, brdf, overflow::excluded>;
  using mul_colour = mul<brdf, colour, out>;

  /// r of an exponent, raw.
  static constexpr std::int64_t fall_of(std::int64_t exponent) {
    if constexpr (is_line) {
      return quarter::law(add_fall::law(exponent, std::int64_t(3), std::int64_t(0)));
    } else {
      return rom_fall::law(0, exponent);
    }
  }

  /// d of an exponent, raw.
  static constexpr std::int64_t rise_of(std::int64_t exponent) {
    if constexpr (is_line) {
      return add_rise::law(exponent, std::int64_t(-1), std::int64_t(0));
    } else {
      return rom_rise::law(1, exponent);
    }
  }

  /// Both rise with n, and d is not negative.
  static constexpr bool both_rise() {
    bool all = rise_of(n::min) >= 0;
    for (std::int64_t i = n::min + 1; i <= n::max; ++i)
      all = all && fall_of(i) >= fall_of(i - 1) && rise_of(i) >= rise_of(i - 1);
    return all;
  }

  /// What no sum within a lobe exceeds, raw: 1 + d/r, its value at the root u = 1/r, rounded up to an integer.
  static constexpr std::int64_t largest_in_lobe() {
    std::int64_t largest = 0;
    for (std::int64_t i = n::min; i <= n::max; ++i) {
      const std::int64_t r = fall_of(i) << (cos_bits + 1 - fall_bits);
      const std::int64_t d = rise_of(i) << (cos_bits + 1 - rise_bits);
      const std::int64_t at_root = 1 + (d + r - 1) / r;
      if (at_root > largest) largest = at_root;
    }
    return largest << part_bits;
  }

  /// No net overflows for any legal input: the laws themselves, taken at the ends of their operands. The quotient is largest
  /// at c = 1, where dividend and divisor are 1.
  static constexpr bool no_overflow() {
    using std::int64_t;
    constexpr int64_t one = 1;
    constexpr int64_t versine_hi = sub_cos::law(int64_t(0));
    constexpr int64_t versine_lo = sub_cos::law(cos_delta::max);
    constexpr int64_t fall_hi = fall_of(n::max);
    constexpr int64_t rise_hi = rise_of(n::max);
    constexpr int64_t drop_hi = mul_fall::law(fall_hi, versine_hi);
    constexpr int64_t drop_lo = mul_fall::law(fall_hi, versine_lo);
    constexpr int64_t line_lo = add_line::law(one, inv_drop::law(drop_hi), one);
    constexpr int64_t line_hi = add_line::law(one, inv_drop::law(drop_lo), one);
    constexpr int64_t climb_hi = mul_rise::law(rise_hi, versine_hi);
    constexpr int64_t sum_hi = add_sum::law(one, climb_hi, int64_t(0));
    constexpr int64_t sum_lo = add_sum::law(one, mul_rise::law(rise_hi, versine_lo), int64_t(0));
    constexpr int64_t quotient_hi = div::law(quant_line::law(line_hi), quant_sum::law(sum_lo));
    static_assert(both_rise());
    static_assert(fits<versine>(versine_lo, versine_hi));
    static_assert(fits<fall>(fall_of(n::min), fall_hi));
    static_assert(fits<rise>(rise_of(n::min), rise_hi));
    static_assert(fits<drop>(drop_lo, drop_hi));
    static_assert(fits<drop_inverted>(inv_drop::law(drop_hi), inv_drop::law(drop_lo)));
    static_assert(fits<line>(line_lo, line_hi));
    static_assert(fits<dividend>(0, line_hi) && quant_line::law(line_lo) == 0);
    static_assert(fits<climb>(0, climb_hi));
    static_assert(fits<sum>(sum_lo, sum_hi));
    static_assert(fits<divisor>(sum_lo, largest_in_lobe()));
    static_assert(fits<quotient>(0, quotient_hi));
    static_assert(fits<brdf>(0, quant::law(quotient_hi)));
    static_assert(fits<out>(0, mul_colour::law(brdf::max, colour::max)));
    if constexpr (is_line) {
      static_assert(fits<n_plus_3>(n::min + 3, n::max + 3));
    }
    return true;
  }
};

}  // namespace blysk
