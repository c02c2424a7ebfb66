// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Takes the sign away: y_o = |a_i|.
///
/// Instances  mag4 of UA 71489: a lobe is the same on both sides of its axis.
/// Formats    a_i: A signed, y_o: Y unsigned with as many fraction bits; the device asserts that |a_i| fits Y.
/// Timing     combinational.   Error  none.
template <class A, class Y>
struct magnitude : sc_core::sc_module {
  static_assert(A::is_signed && !Y::is_signed && A::frac == Y::frac);

  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<typename Y::raw_t> SC_NAMED(y_o);

  SC_CTOR(magnitude) {
    SC_METHOD(eval);
    sensitive << a_i;
  }

  template <class T>
  static constexpr T law(T a) {
    return law::magnitude(a);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("magnitude", "Takes the sign away: y_o = |a_i|.");
    reader.drive(y_o, law(reader.read(a_i, A{})), Y{});
  }

 private:
  void eval() { y_o.write(law<std::int64_t>(a_i.read().to_int64())); }
};

}  // namespace blysk
