// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// The sign of a_i: negative_o = a_i < 0, its first bit.
///
/// Instances  sign8, at adder 8 of [T] fig. 3.1, in the place of comparator 11 and ROM 9 (spec erratum E5).
/// Formats    a_i: A signed, negative_o: one bit.
/// Timing     combinational.   Error  none.
template <class A>
struct sign : sc_core::sc_module {
  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<bool> SC_NAMED(negative_o);

  SC_CTOR(sign) {
    SC_METHOD(eval);
    sensitive << a_i;
  }

  template <class T>
  static constexpr T law(T a) {
    static_assert(A::is_signed, "an unsigned number has no sign");
    return law::is_negative(a);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("sign", "The sign of a_i: negative_o = a_i < 0.");
    reader.drive(negative_o, law(reader.read(a_i, A{})));
  }

 private:
  void eval() { negative_o.write(law<std::int64_t>(a_i.read().to_int64()) != 0); }
};

}  // namespace blysk
