// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// y_o = 1 - a_i.
///
/// Instances  sub of the arc cosine.
/// Formats    a_i, y_o: unit<Frac>; codes of a_i above 1 are not legal.
/// Timing     combinational.   Error  none.
template <int Frac>
struct one_minus : sc_core::sc_module {
  using number = unit<Frac>;

  sc_core::sc_in<typename number::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<typename number::raw_t> SC_NAMED(y_o);

  SC_CTOR(one_minus) {
    SC_METHOD(eval);
    sensitive << a_i;
  }

  template <class T>
  static constexpr T law(T a) {
    return law::subtract(static_cast<T>(number::max), a);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("one_minus", "Subtracter: y_o = 1 - a_i.");
    reader.drive(y_o, law(reader.read(a_i, number{})), number{});
  }

 private:
  void eval() { y_o.write(law<std::int64_t>(a_i.read().to_int64())); }
};

}  // namespace blysk
