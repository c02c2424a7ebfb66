// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// The same number with other fraction bits: y_o = a_i, exact when Y keeps all of A's, else rounded to nearest (ties up).
///
/// Instances  ambient, specular: terms of a sum of lights.
/// Formats    a_i: A, y_o: Y; the device asserts that no number overflows Y.
/// Timing     combinational, wires alone when exact.   Error  0, or 1/2 ulp of Y if Y::frac < A::frac.
template <class A, class Y>
struct rescale : sc_core::sc_module {
  static_assert(law::rounds_within(A::width, A::frac < Y::frac ? 0 : A::frac - Y::frac),
                "a number is rounded within 64 bits");

  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<typename Y::raw_t> SC_NAMED(y_o);

  SC_CTOR(rescale) {
    SC_METHOD(eval);
    sensitive << a_i;
  }

  template <class T>
  static constexpr T law(T a) {
    return law::rescale(a, A::frac, Y::frac, law::has_headroom(A::width));
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("rescale", Y::frac >= A::frac
                                   ? "Wires: y_o = a_i with as many fraction bits or more, exact."
                                   : "y_o = a_i with fewer fraction bits, rounded to nearest, ties up.");
    reader.drive(y_o, law(reader.read(a_i, A{})), Y{});
  }

 private:
  void eval() { y_o.write(law<std::int64_t>(a_i.read().to_int64())); }
};

}  // namespace blysk
