// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Adder with carry: s_o = a_i + b_i + carry_i 2^-CarryFrac, operands aligned by wiring to the fraction bits of S.
///
/// Instances  add9 (carry 28 = 1: completes the two's complement of cos), add11 (carry 30 = 0), add15 of
///            [P] fig. 1; add6 and add8 (carry 29 = 1: adds unity) of [T] fig. 3.1.
/// Formats    a_i: A, b_i: B, s_o: S with S::frac >= A::frac, B::frac; the carry weighs 2^-CarryFrac, 1 ulp of S unless
///            another weight is asked for. The device asserts that no sum overflows S.
/// Timing     combinational.   Error  none.
template <class A, class B, class S, int CarryFrac = S::frac>
struct add : sc_core::sc_module {
  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<typename B::raw_t> SC_NAMED(b_i);
  sc_core::sc_in<uq<1, 0>::raw_t> SC_NAMED(carry_i);
  sc_core::sc_out<typename S::raw_t> SC_NAMED(s_o);

  SC_CTOR(add) {
    SC_METHOD(eval);
    sensitive << a_i << b_i << carry_i;
  }

  template <class T>
  static constexpr T law(T a, T b, T carry) {
    static_assert(S::frac >= A::frac && S::frac >= B::frac && S::frac >= CarryFrac,
                  "an adder does not round");
    return law::add(a, S::frac - A::frac, b, S::frac - B::frac, law::move_up(carry, S::frac - CarryFrac));
  }

  template <class Reader>
  void describe(Reader& reader) const {
    static_assert(CarryFrac == S::frac || CarryFrac == 0, "no other weight has a name");
    if constexpr (CarryFrac == S::frac) {
      reader.block_is("add", "Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.");
    } else {
      reader.block_is("add", "Adder: s_o = a_i + b_i + carry_i, the carry weighing 1.", "unity_carry");
    }
    reader.drive(s_o, law(reader.read(a_i, A{}), reader.read(b_i, B{}), reader.read(carry_i)), S{});
  }

 private:
  void eval() {
    s_o.write(law<std::int64_t>(a_i.read().to_int64(), b_i.read().to_int64(), carry_i.read().to_int64()));
  }
};

}  // namespace blysk
