// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/qformat.h"

namespace blysk {

/// The same wires with another binary point: y_o = a_i 2^(A::frac - Y::frac), a division by a power of two.
///
/// Instances  part_n of Lyon's lobe.
/// Formats    a_i: A, y_o: Y, of the same width and sign.
/// Timing     none.   Error  none.
template <class A, class Y>
struct move_point : sc_core::sc_module {
  static_assert(A::width == Y::width && A::is_signed == Y::is_signed, "the wires are the same");

  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<typename Y::raw_t> SC_NAMED(y_o);

  SC_CTOR(move_point) {
    SC_METHOD(eval);
    sensitive << a_i;
  }

  template <class T>
  static constexpr T law(T a) {
    return a;
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("move_point", "Wires: y_o = the bits of a_i, with another binary point.");
    reader.drive(y_o, law(reader.read(a_i, A{})), Y{});
  }

 private:
  void eval() { y_o.write(law<std::int64_t>(a_i.read().to_int64())); }
};

}  // namespace blysk
