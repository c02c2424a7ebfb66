// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Key block, an AND gate for each bit: y_o = a_i, or 0 while off_i is one.
///
/// Instances  key12 of [T] fig. 3.1.
/// Formats    a_i, y_o: Q, off_i: one bit.
/// Timing     combinational.   Error  none.
template <class Q>
struct key : sc_core::sc_module {
  sc_core::sc_in<typename Q::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<bool> SC_NAMED(off_i);
  sc_core::sc_out<typename Q::raw_t> SC_NAMED(y_o);

  SC_CTOR(key) {
    SC_METHOD(eval);
    sensitive << a_i << off_i;
  }

  template <class T>
  static constexpr T law(T a, T off) {
    return law::gate(a, off);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("key", "Key block: y_o = a_i, or 0 while off_i is one.");
    const auto off = reader.read(off_i);
    reader.drive(y_o, law(reader.read(a_i, Q{}), off), Q{});
  }

 private:
  void eval() { y_o.write(law<std::int64_t>(a_i.read().to_int64(), off_i.read() ? 1 : 0)); }
};

}  // namespace blysk
