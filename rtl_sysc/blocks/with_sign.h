// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

namespace law {

/// -a where `negative` is one, else a.
template <class T>
constexpr T with_sign(T negative, T a) {
  return select(negative, static_cast<T>(-a), a);
}

}  // namespace law

/// Gives a number its sign: y_o = -a_i while negative_i is one, else a_i.
///
/// Instances  sign_quotient of the restoring divider.
/// Formats    a_i: A unsigned, y_o: Y signed with as many fraction bits; the device asserts that a_i fits Y.
/// Timing     combinational.   Error  none.
template <class A, class Y>
struct with_sign : sc_core::sc_module {
  static_assert(!A::is_signed && Y::is_signed && A::frac == Y::frac);

  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<bool> SC_NAMED(negative_i);
  sc_core::sc_out<typename Y::raw_t> SC_NAMED(y_o);

  SC_CTOR(with_sign) {
    SC_METHOD(eval);
    sensitive << a_i << negative_i;
  }

  template <class T>
  static constexpr T law(T negative, T a) {
    return law::with_sign(negative, a);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("with_sign", "Gives a number its sign: y_o = -a_i while negative_i is one, else a_i.");
    const auto negative = reader.read(negative_i);
    reader.drive(y_o, law(negative, reader.read(a_i, A{})), Y{});
  }

 private:
  void eval() { y_o.write(law<std::int64_t>(negative_i.read() ? 1 : 0, a_i.read().to_int64())); }
};

}  // namespace blysk
