// SPDX-License-Identifier: Apache-2.0
/// The format of every net of the devices, computed from the fraction bits of cos(delta).
#pragma once

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/inverter_bank.h"
#include "rtl_sysc/blocks/mul.h"
#include "rtl_sysc/blocks/quantise.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Named formats, what a user picks: q8 .. q24 are the fraction bits of cos(delta).
template <int Frac>
struct named_format {
  static constexpr int frac = Frac;
};

struct q8 : named_format<8> {};
struct q10 : named_format<10> {};
struct q12 : named_format<12> {};
struct q14 : named_format<14> {};
struct q16 : named_format<16> {};
struct q18 : named_format<18> {};
struct q20 : named_format<20> {};
struct q22 : named_format<22> {};
struct q24 : named_format<24> {};

/// What becomes of the parabola's negative lobe, 0 < c < 1 - 1/a (spec erratum E4).
enum class lobe {
  clamped,      ///< the BRDF is clamped to [0, 1]
  as_published  ///< it goes through, down to -a/4, about -196 at n = 1000
};

constexpr int min_of(int a, int b) {
  return a < b ? a : b;
}

/// Specular exponent n, 1..1000.
struct exponent : uq<10, 0> {
  static constexpr std::int64_t min = 1;
  static constexpr std::int64_t max = 1000;
};

using colour = uq<8, 0>;  ///< R, G or B times k_s, 0..255
using carry = uq<1, 0>;

/// Nets of [P] fig. 1 for F = Q::frac fraction bits of cos(delta).
///
/// The coefficient's constant has min(F, 20) bits: S = 2(1 - e^(-1/2)) rounded to 20 bits is within 1.4e-8, a
/// quarter of q24's ulp, so more would buy nothing. cos^2 is exact up to q12; from q14 on it keeps F + 12 bits
/// (q24: 35), since a < 2^10 makes its rounding cost at most 2^10 * 2^-(F+13) = 1/8 ulp of the BRDF (q24: 1/4),
/// and all sums stay within 64 bits. The BRDF has F fraction bits again.
template <class Q, lobe Lobe>
struct quadratic_formats {
  static constexpr int cos_bits = Q::frac;
  static constexpr int slope_bits = min_of(Q::frac, 20);
  static constexpr int diff_bits = min_of(min_of(2 * Q::frac, Q::frac + 12), 35);

  using n = exponent;
  using cos_delta = unit<cos_bits>;
  using slope = uq<0, slope_bits>;               // node 31
  using offset = sq<0, 1>;                       // node 32: +1/2 or -1/2
  using slope_n = uq<10, slope_bits>;            // multiplier 6
  using a = uq<10, slope_bits>;                  // adder 15
  using cos2 = uq<1, diff_bits>;                 // multiplier 7
  using cos_inv = sq<1, diff_bits>;              // inverter bank 8
  using diff = sq<-2, diff_bits>;                // adder 9: cos^2 - cos, [-1/4, 0]
  using a_diff = sq<8, slope_bits + diff_bits>;  // multiplier 10
  using parabola = a_diff;                       // adder 11
  using brdf = std::conditional_t<Lobe == lobe::clamped, unit<cos_bits>, sq<8, cos_bits>>;
  using out = std::conditional_t<Lobe == lobe::clamped, uq<8, cos_bits>, sq<16, cos_bits>>;  // 12..14

  using mul6 = mul<n, slope, slope_n>;
  using add15 = add<slope_n, offset, a>;
  using mul7 = mul<cos_delta, cos_delta, cos2>;
  using inv8 = inverter_bank<cos_delta, cos_inv>;
  using add9 = add<cos2, cos_inv, diff>;
  using mul10 = mul<a, diff, a_diff>;
  using add11 = add<a_diff, cos_delta, parabola>;
  using quant11 = quantise<parabola, brdf, Lobe == lobe::clamped ? overflow::clamp : overflow::excluded>;
  using mul_colour = mul<brdf, colour, out>;  // 12, 13, 14

  /// No net overflows for any legal input: the laws themselves, taken at the ends of their operands. The slope
  /// lies in [1/2, 1), what wired_slope() checks; c^2 - c has its minimum -1/4 at c = 1/2.
  static constexpr bool no_overflow() {
    using std::int64_t;
    constexpr int64_t one = cos_delta::max;
    constexpr int64_t half = one / 2;
    constexpr int64_t slope_lo = int64_t{1} << (slope_bits - 1);
    constexpr int64_t slope_n_hi = mul6::law(n::max, slope::max);
    constexpr int64_t a_lo = add15::law(mul6::law(n::min, slope_lo), int64_t{-1}, int64_t{0});
    constexpr int64_t a_hi = add15::law(slope_n_hi, int64_t{1}, int64_t{0});
    constexpr int64_t cos2_hi = mul7::law(one, one);
    constexpr int64_t diff_lo = add9::law(mul7::law(half, half), inv8::law(half), int64_t{1});
    constexpr int64_t diff_hi = add9::law(cos2_hi, inv8::law(one), int64_t{1});
    constexpr int64_t a_diff_lo = mul10::law(a_hi, diff_lo);
    constexpr int64_t parabola_hi = add11::law(int64_t{0}, one, int64_t{0});
    constexpr int64_t brdf_lo = quant11::law(a_diff_lo);
    constexpr int64_t brdf_hi = quant11::law(parabola_hi);
    static_assert(fits<slope_n>(0, slope_n_hi));
    static_assert(fits<a>(a_lo, a_hi));
    static_assert(fits<cos2>(0, cos2_hi));
    static_assert(fits<cos_inv>(inv8::law(one), inv8::law(int64_t{0})));
    static_assert(fits<diff>(diff_lo, diff_hi) && diff_hi == 0);
    static_assert(fits<a_diff>(a_diff_lo, 0));
    static_assert(fits<parabola>(a_diff_lo, parabola_hi));
    static_assert(fits<brdf>(brdf_lo, brdf_hi));
    static_assert(fits<out>(mul_colour::law(brdf_lo, colour::max), mul_colour::law(brdf_hi, colour::max)));
    return true;
  }
};

/// The wires of nodes 31 and 32: a = slope n + offset.
struct wired_constants {
  std::int64_t slope;   ///< raw of UQ0.k, its first bit is one
  std::int64_t offset;  ///< raw of SQ0.1: 1 is +1/2, -1 is -1/2
};

/// Node 31 and 32 of the line a = 0.786 n + 0.5, [P] (10), for a constant of `bits` bits, rounded to nearest:
/// 8 bits give 0.11001001b, what [P] prints as "bits 1, 2, 5, 6" (spec errata E1..E3).
constexpr wired_constants published_line(int bits) {
  wired_constants wired{};
  wired.slope = ((std::int64_t{786} << bits) + 500) / 1000;
  wired.offset = 1;
  return wired;
}

/// Node 31 and 32 of the line that follows from [P] (9): a = S n - 1/2, S = 2(1 - e^(-1/2)).
constexpr wired_constants derived_line(int bits) {
  constexpr std::int64_t slope_q60 = 907278527641548290;  // S * 2^60
  wired_constants wired{};
  wired.slope = (slope_q60 + (std::int64_t{1} << (59 - bits))) >> (60 - bits);
  wired.offset = -1;
  return wired;
}

}  // namespace blysk
