// SPDX-License-Identifier: Apache-2.0
/// The formats of the nets of [T] fig. 3.1.
#pragma once

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/compare.h"
#include "rtl_sysc/blocks/key.h"
#include "rtl_sysc/blocks/mul.h"
#include "rtl_sysc/blocks/quantise.h"
#include "rtl_sysc/devices/cosine_quadratic/contents.h"
#include "rtl_sysc/formats.h"

namespace blysk {

/// What closes key block 12.
enum class root_gate {
  sign,  ///< the sign of adder 8's sum: the lobe ends at its root (spec erratum E5)
  limit  ///< comparator 11, where the square is below the word of ROM 9, as printed: the second lobe gets through
};

/// What the all ones at adder 6 and the carry 29 at adder 8 weigh.
enum class constant_weight {
  unity,  ///< 1 (spec erratum E6)
  lsb     ///< the last place of the adder, as printed
};

/// A number of [-1, 1], both ends included: wired as SQ1.f, no other codes are legal.
template <int Frac>
struct signed_unit : sq<1, Frac> {
  static constexpr std::int64_t max = std::int64_t(1) << Frac;
  static constexpr std::int64_t min = -max;
};

/// Nets of [T] fig. 3.1 for Q::frac fraction bits of cos(gamma). The BRDF has Q::frac fraction bits again.
///
/// Gated by the sign, with constants of unity, the line m (c - 1) + 1 is limited to [-1, 1] before it is squared: below -1
/// the key block is closed. It keeps three fraction bits more than the BRDF: its rounding costs at most 1/8 ulp.
/// As printed, either of them, nothing limits the line: it reaches -332.7 or 333.7, its square 111 334. It keeps at most
/// 22 fraction bits, so that the square takes no more than 64 bits.
/// \tparam HasFactor  an energy factor, up to 41, multiplies the BRDF; line and square keep six bits more for it
template <class Q, root_gate Gate, constant_weight Weight, bool HasFactor>
struct cosine_quadratic_formats {
  static constexpr root_gate gate = Gate;
  static constexpr constant_weight weight = Weight;
  static constexpr bool has_factor = HasFactor;
  static constexpr bool is_limited = Gate == root_gate::sign && Weight == constant_weight::unity;
  static_assert(is_limited || !HasFactor, "an energy factor is for the lobe alone");

  static constexpr int cos_bits = Q::frac;
  static constexpr int slope_bits = Q::frac;
  static constexpr int line_bits = !is_limited ? min_of(Q::frac + 3, 22)
                                   : HasFactor ? min_of(min_of(Q::frac + 9, 2 * Q::frac), 30)
                                               : Q::frac + 3;
  static constexpr int square_bits = HasFactor ? Q::frac + 6 : Q::frac;
  static constexpr int limit_bits = Q::frac;
  static constexpr int factor_bits = Q::frac + 2;
  static constexpr int weight_bits = Weight == constant_weight::unity ? 0 : Q::frac;  // of the all ones

  using n = exponent;
  using cos_delta = unit<cos_bits>;
  using minus_one = sq<0, weight_bits>;          // second input of adder 6, all ones
  using cos_minus_1 = sq<0, cos_bits>;           // adder 6
  using slope = uq<9, slope_bits>;               // ROM 33: m = (n + 1)/3
  using product = sq<9, slope_bits + cos_bits>;  // multiplier 7
  using line = product;                          // adder 8
  using rounded = std::conditional_t<is_limited, signed_unit<line_bits>, sq<9, line_bits>>;
  using square = std::conditional_t<is_limited, unit<square_bits>, uq<17, square_bits>>;  // multiplier 10
  using limit = uq<-4, limit_bits>;                                                       // ROM 9: below 1/16
  using factor = uq<6, factor_bits>;
  using scaled = uq<6, cos_bits>;
  using brdf = std::conditional_t<HasFactor, scaled, square>;
  using out = std::conditional_t<HasFactor, uq<14, cos_bits>,
                                 std::conditional_t<is_limited, uq<8, cos_bits>, uq<25, cos_bits>>>;

  using slopes = slope_words<slope_bits>;
  using limits = limit_words<limit_bits>;
  using factors = factor_words<factor_bits>;

  using add6 = add<cos_delta, minus_one, cos_minus_1>;
  using mul7 = mul<slope, cos_minus_1, product>;
  using add8 = add<product, carry, line, Weight == constant_weight::unity ? 0 : line::frac>;
  using quant8 = quantise<line, rounded, is_limited ? overflow::clamp : overflow::excluded>;
  using mul10 = mul<rounded, rounded, square>;
  using cmp11 = compare<square, limit>;
  using key12 = key<square>;
  using mul_factor = mul<square, factor, scaled>;
  using mul_colour = mul<brdf, colour, out>;

  /// No net overflows for any legal input: the laws themselves, taken at the ends of their operands. m grows with n, and
  /// the line grows with c.
  static constexpr bool no_overflow() {
    using std::int64_t;
    constexpr int64_t slope_hi = slopes::words[0][1000];
    constexpr int64_t ones = -1;
    constexpr int64_t versine_lo = add6::law(int64_t(0), ones, int64_t(0));
    constexpr int64_t versine_hi = add6::law(cos_delta::max, ones, int64_t(0));
    constexpr int64_t product_lo = mul7::law(slope_hi, versine_lo);
    constexpr int64_t product_hi = mul7::law(slope_hi, versine_hi);
    constexpr int64_t line_lo = add8::law(product_lo, int64_t(0), int64_t(1));
    constexpr int64_t line_hi = add8::law(product_hi, int64_t(0), int64_t(1));
    constexpr int64_t rounded_lo = quant8::law(line_lo);
    constexpr int64_t rounded_hi = quant8::law(line_hi);
    constexpr int64_t square_lo = mul10::law(rounded_lo, rounded_lo);
    constexpr int64_t square_hi = mul10::law(rounded_hi, rounded_hi);
    static_assert(fits<minus_one>(ones, ones));
    static_assert(fits<cos_minus_1>(versine_lo, versine_hi));
    static_assert(fits<slope>(0, slope_hi));
    static_assert(fits<product>(product_lo, product_hi));
    static_assert(fits<line>(line_lo, line_hi));
    if constexpr (is_limited) {
      constexpr int64_t unity = int64_t(1) << line_bits;
      static_assert(fits<rounded>(-unity, unity) && rounded_lo == -unity && rounded_hi == unity);
    } else {
      static_assert(fits<rounded>(rounded_lo, rounded_hi));
    }
    static_assert(fits<square>(0, square_lo) && fits<square>(0, square_hi));
    if constexpr (Gate == root_gate::limit) {
      static_assert(fits<limit>(0, limits::words[0][1000]));
      static_assert(cmp11::law(int64_t(0), limits::words[0][1000]) == 1);
    }
    if constexpr (HasFactor) {
      constexpr int64_t factor_hi = factors::words[0][1000];
      constexpr int64_t scaled_hi = mul_factor::law(square::max, factor_hi);
      static_assert(fits<factor>(factors::words[1][1000], factor_hi));
      static_assert(fits<scaled>(0, scaled_hi));
      static_assert(fits<out>(0, mul_colour::law(scaled_hi, colour::max)));
    } else {
      constexpr int64_t brdf_hi = square_lo < square_hi ? square_hi : square_lo;
      static_assert(fits<out>(0, mul_colour::law(brdf_hi, colour::max)));
    }
    return true;
  }
};

}  // namespace blysk
