// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Some of the wires of a number: y_o = the Y::width bits of a_i from bit Low on.
///
/// Instances  what cuts numbers and takes addresses from them in the path by a logarithm.
/// Formats    a_i: A unsigned, y_o: Y unsigned, Low + Y::width <= A::width.
/// Timing     none.   Error  none; as a cut, what lies below bit Low is lost.
template <class A, class Y, int Low>
struct field : sc_core::sc_module {
  static_assert(!A::is_signed && !Y::is_signed && Low >= 0 && Low + Y::width <= A::width,
                "a field lies within an unsigned number");

  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<typename Y::raw_t> SC_NAMED(y_o);

  SC_CTOR(field) {
    SC_METHOD(eval);
    sensitive << a_i;
  }

  template <class T>
  static constexpr T law(T a) {
    if constexpr (Low + Y::width == A::width) {
      return law::upper_bits(a, Low);
    } else {
      return law::lower_bits(law::upper_bits(a, Low), Y::width);
    }
  }

  template <class Reader>
  void describe(Reader& reader) const {
    static_assert(Low < 100, "the names of the variants have two digits");
    constexpr char variant[] = {'f', 'r', 'o', 'm', '_', char('0' + Low / 10), char('0' + Low % 10), 0};
    reader.block_is("field", "Wires: y_o = the bits of a_i from one on, as many as y_o has.", variant);
    reader.drive(y_o, law(reader.read(a_i, A{})), Y{});
  }

 private:
  void eval() { y_o.write(law<std::int64_t>(a_i.read().to_int64())); }
};

}  // namespace blysk
