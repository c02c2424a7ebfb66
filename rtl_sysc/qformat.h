// SPDX-License-Identifier: Apache-2.0
/// Q-formats: how the integer on a bundle of wires (raw) stands for a real number, value = raw * 2^-frac.
#pragma once

#include <cstdint>
#include <systemc>
#include <type_traits>

namespace blysk {

/// UQm.f: unsigned, m integer and f fraction bits, [0, 2^m - 2^-f]. m may be negative: leading zeros not wired.
template <int Integer, int Frac>
struct uq {
  static constexpr int frac = Frac;
  static constexpr int width = Integer + Frac;
  static constexpr bool is_signed = false;
  static_assert(width >= 1 && width <= 63, "the raw value has to fit an int64_t");
  static constexpr std::int64_t min = 0;
  static constexpr std::int64_t max = static_cast<std::int64_t>((std::uint64_t{1} << width) - 1);
  using raw_t = sc_dt::sc_uint<width>;
};

/// SQm.f: two's complement, 1 + m + f bits (m never counts the sign), [-2^m, 2^m - 2^-f].
template <int Integer, int Frac>
struct sq {
  static constexpr int frac = Frac;
  static constexpr int width = 1 + Integer + Frac;
  static constexpr bool is_signed = true;
  static_assert(width >= 1 && width <= 64, "the raw value has to fit an int64_t");
  static constexpr std::int64_t max = static_cast<std::int64_t>((std::uint64_t{1} << (width - 1)) - 1);
  static constexpr std::int64_t min = -max - 1;
  using raw_t = sc_dt::sc_int<width>;
};

/// A number of [0, 1], both ends included: wired as UQ1.f, codes above 2^f are not legal.
template <int Frac>
struct unit : uq<1, Frac> {
  static constexpr std::int64_t max = std::int64_t{1} << Frac;
};

/// Format of the exact product of an A and a B: integer and fraction bits add.
template <class A, class B>
using product_of = std::conditional_t<A::is_signed || B::is_signed,
                                      sq<A::width + B::width - A::frac - B::frac - 1, A::frac + B::frac>,
                                      uq<A::width + B::width - A::frac - B::frac, A::frac + B::frac>>;

/// True if every raw value of [lo, hi] has its own code in format Q.
template <class Q>
constexpr bool fits(std::int64_t lo, std::int64_t hi) {
  return Q::min <= lo && lo <= hi && hi <= Q::max;
}

/// A wire of one bit that carries no number, where a format is asked for.
struct single_bit {
  using raw_t = bool;
};

}  // namespace blysk
