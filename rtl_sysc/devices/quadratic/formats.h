// SPDX-License-Identifier: Apache-2.0
/// The formats of the nets of [P] fig. 1 that lead from n to the coefficient a, and the wires of its nodes 31 and 32.
#pragma once

#include "rtl_sysc/devices/parabola.h"

namespace blysk {

/// Fraction bits of the slope's constant, and so of a, for `frac` fraction bits of cos(delta). S = 2(1 - e^(-1/2))
/// rounded to 20 bits is within 1.4e-8, a quarter of q24's ulp, so more would buy nothing.
constexpr int slope_bits(int frac) {
  return min_of(frac, 20);
}

/// Nets of [P] fig. 1 for Q::frac fraction bits of cos(delta).
template <class Q, negative_lobe Lobe>
struct quadratic_formats : parabola_formats<Q, Lobe, slope_bits(Q::frac)> {
  using base = parabola_formats<Q, Lobe, slope_bits(Q::frac)>;
  using n = typename base::n;
  using a = typename base::a;
  using slope = uq<0, base::coefficient_bits>;     // node 31
  using offset = sq<0, 1>;                         // node 32: +1/2 or -1/2
  using slope_n = uq<10, base::coefficient_bits>;  // multiplier 6

  using mul6 = mul<n, slope, slope_n>;
  using add15 = add<slope_n, offset, a>;

  /// No net overflows for any legal input. The slope lies in [1/2, 1), so that a >= 0; what chooses the wires
  /// checks that its first bit is one.
  static constexpr bool no_overflow() {
    using std::int64_t;
    constexpr int64_t slope_lo = int64_t(1) << (base::coefficient_bits - 1);
    constexpr int64_t slope_n_hi = mul6::law(n::max, slope::max);
    constexpr int64_t a_lo = add15::law(mul6::law(n::min, slope_lo), int64_t(-1), int64_t(0));
    constexpr int64_t a_hi = add15::law(slope_n_hi, int64_t(1), int64_t(0));
    static_assert(fits<slope_n>(0, slope_n_hi));
    static_assert(fits<a>(a_lo, a_hi));
    return base::template no_overflow_up_to<a_hi>();
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
