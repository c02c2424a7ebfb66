// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// OR gate: y_o = one, if b_i or any bit of a_i is.
///
/// Instances  off of the path by a logarithm.
/// Formats    a_i: A, b_i and y_o: one bit.
/// Timing     combinational.   Error  none.
template <class A>
struct either : sc_core::sc_module {
  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<bool> SC_NAMED(b_i);
  sc_core::sc_out<bool> SC_NAMED(y_o);

  SC_CTOR(either) {
    SC_METHOD(eval);
    sensitive << a_i << b_i;
  }

  template <class T>
  static constexpr T law(T a, T b) {
    return law::either(a, b);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("either", "OR gate: y_o = one, if b_i or any bit of a_i is.");
    const auto b = reader.read(b_i);
    reader.drive(y_o, law(reader.read(a_i, A{}), b));
  }

 private:
  void eval() { y_o.write(law<std::int64_t>(a_i.read().to_int64(), b_i.read() ? 1 : 0) != 0); }
};

}  // namespace blysk
