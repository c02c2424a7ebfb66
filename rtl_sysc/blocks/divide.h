// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Divider: q_o = a_i / b_i, rounded down, for a_i <= b_i: a row of subtractors, one for each bit of the quotient, each of
/// which keeps its difference if that is not negative.
///
/// Instances  div of Schlick's lobe and of GX's.
/// Formats    a_i: A, b_i: B, unsigned, A with no more fraction bits than B; q_o: UQ1.f. A division by 0 gives all ones.
/// Timing     combinational.   Error  below 1 ulp of q_o, downwards.
template <class A, class B, class Q>
struct divide : sc_core::sc_module {
  static constexpr int a_shift = B::frac - A::frac;  // by wiring
  static_assert(!A::is_signed && !B::is_signed && a_shift >= 0 && Q::width == Q::frac + 1);
  static_assert(A::width + a_shift <= B::width && B::width <= 61);

  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<typename B::raw_t> SC_NAMED(b_i);
  sc_core::sc_out<typename Q::raw_t> SC_NAMED(q_o);

  SC_CTOR(divide) {
    SC_METHOD(eval);
    sensitive << a_i << b_i;
  }

  template <class T>
  static constexpr T law(T a, T b) {
    using law::select;
    T rest = law::move_up(a, a_shift);
    T quotient = static_cast<T>(0);
    for (int bit = Q::frac; bit >= 0; --bit) {
      const T is_less = static_cast<T>(rest < b);
      quotient = quotient | law::move_up(law::is_idle(is_less), bit);
      const T kept = law::lower_bits(select(is_less, rest, static_cast<T>(rest - b)), B::width);
      rest = law::move_up(kept, 1);
    }
    return quotient;
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
