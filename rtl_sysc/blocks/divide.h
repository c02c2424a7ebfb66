// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

namespace law {

/// Restoring division, a digit at a time: what is left of the dividend after a digit, moved up for the next one.
/// \param is_less  1 if rest < b: the digit is zero, and nothing is taken off
/// \param width    bits of b
template <class T>
constexpr T rest_after_digit(T is_less, T rest, T b, int width) {
  const T kept = lower_bits(select(is_less, rest, static_cast<T>(rest - b)), width);
  return move_up(kept, 1);
}

/// rest / b, rounded down, for rest <= b.
/// \param width   bits of b
/// \param places  fraction bits of the quotient
template <class T>
constexpr T divide(T rest, T b, int width, int places) {
  T quotient = static_cast<T>(0);
  for (int bit = places; bit >= 0; --bit) {
    const T is_less = static_cast<T>(rest < b);
    quotient = quotient | move_up(is_idle(is_less), bit);
    rest = rest_after_digit(is_less, rest, b, width);
  }
  return quotient;
}

}  // namespace law

/// Divider: q_o = a_i / b_i, rounded down, for a_i <= b_i: a row of subtractors, one for each bit of the quotient, each of
/// which keeps its difference if that is not negative.
///
/// Instances  div of lobes that are quotients. divide_steps is the same row in time.
/// Formats    a_i: A, b_i: B, unsigned, aligned by wiring to the finer one's fraction bits; q_o: UQ1.f. A division by 0
///            gives all ones.
/// Timing     combinational.   Error  below 1 ulp of q_o, downwards.
template <class A, class B, class Q>
struct divide : sc_core::sc_module {
  static constexpr int a_shift = A::frac < B::frac ? B::frac - A::frac : 0;  // by wiring
  static constexpr int b_shift = B::frac < A::frac ? A::frac - B::frac : 0;
  static constexpr int width = B::width + b_shift;
  static_assert(!A::is_signed && !B::is_signed && Q::width == Q::frac + 1);
  static_assert(A::width + a_shift <= width && width <= 61);

  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<typename B::raw_t> SC_NAMED(b_i);
  sc_core::sc_out<typename Q::raw_t> SC_NAMED(q_o);

  SC_CTOR(divide) {
    SC_METHOD(eval);
    sensitive << a_i << b_i;
  }

  template <class T>
  static constexpr T law(T a, T b) {
    return law::divide(law::move_up(a, a_shift), aligned(b), width, Q::frac);
  }

  /// b with the fraction bits of the finer one.
  template <class T>
  static constexpr T aligned(T b) {
    if constexpr (b_shift == 0) {
      return b;
    } else {
      return law::move_up(b, b_shift);
    }
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("divide", "Divider: q_o = a_i / b_i, rounded down, for a_i <= b_i.");
    const auto a = reader.read(a_i, A{});
    reader.drive(q_o, law(a, reader.read(b_i, B{})), Q{});
  }

 private:
  void eval() { q_o.write(law<std::int64_t>(a_i.read().to_int64(), b_i.read().to_int64())); }
};

}  // namespace blysk
