// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Comparator: below_o = a_i < b_i, operands aligned by wiring to the finer one's fraction bits.
///
/// Instances  cmp11 of [T] fig. 3.1: the square against the limit for n.
/// Formats    a_i: A, b_i: B, below_o: one bit.
/// Timing     combinational.   Error  none.
template <class A, class B>
struct compare : sc_core::sc_module {
  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<typename B::raw_t> SC_NAMED(b_i);
  sc_core::sc_out<bool> SC_NAMED(below_o);

  SC_CTOR(compare) {
    SC_METHOD(eval);
    sensitive << a_i << b_i;
  }

  template <class T>
  static constexpr T law(T a, T b) {
    constexpr int frac = A::frac > B::frac ? A::frac : B::frac;
    static_assert(A::width + frac - A::frac <= 63 && B::width + frac - B::frac <= 63,
                  "aligned operands have to fit an int64_t");
    return law::below(a, frac - A::frac, b, frac - B::frac);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("compare", "Comparator: below_o = a_i < b_i.");
    reader.drive(below_o, law(reader.read(a_i, A{}), reader.read(b_i, B{})));
  }

 private:
  void eval() { below_o.write(law<std::int64_t>(a_i.read().to_int64(), b_i.read().to_int64()) != 0); }
};

}  // namespace blysk
