// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Multiplexer: y_o = b_i while select_b_i is one, else a_i.
///
/// Instances  mux of UA 71489: the sum of the adder, or the start angle of register 3.
/// Formats    a_i: A, b_i: B, y_o: Y, all with the same fraction bits; Y holds the codes of A and of B.
/// Timing     combinational.   Error  none.
template <class A, class B, class Y>
struct multiplexer : sc_core::sc_module {
  static_assert(A::frac == Y::frac && B::frac == Y::frac);
  static_assert(fits<Y>(A::min, A::max) && fits<Y>(B::min, B::max));

  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<typename B::raw_t> SC_NAMED(b_i);
  sc_core::sc_in<bool> SC_NAMED(select_b_i);
  sc_core::sc_out<typename Y::raw_t> SC_NAMED(y_o);

  SC_CTOR(multiplexer) {
    SC_METHOD(eval);
    sensitive << a_i << b_i << select_b_i;
  }

  template <class T>
  static constexpr T law(T a, T b, T takes_b) {
    using law::select;
    return select(takes_b, b, a);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("multiplexer", "Multiplexer: y_o = b_i while select_b_i is one, else a_i.");
    const auto a = reader.read(a_i, A{});
    const auto b = reader.read(b_i, B{});
    reader.drive(y_o, law(a, b, reader.read(select_b_i)), Y{});
  }

 private:
  void eval() {
    y_o.write(law<std::int64_t>(a_i.read().to_int64(), b_i.read().to_int64(), select_b_i.read() ? 1 : 0));
  }
};

}  // namespace blysk
