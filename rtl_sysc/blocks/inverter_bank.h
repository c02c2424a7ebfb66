// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Inverter bank: the ones' complement of a_i at Y's width, y_o = -a_i - 1 ulp of Y.
///
/// The bits below a_i and its sign are wired zeros; inverted, they are wired ones, so that a carry-in of one LSB
/// of Y completes the two's complement.
///
/// Instances  inv8 of [P] fig. 1.
/// Formats    a_i: A unsigned, y_o: Y signed with Y::frac >= A::frac.
/// Timing     combinational.   Error  none.
template <class A, class Y>
struct inverter_bank : sc_core::sc_module {
  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<typename Y::raw_t> SC_NAMED(y_o);

  SC_CTOR(inverter_bank) {
    SC_METHOD(eval);
    sensitive << a_i;
  }

  template <class T>
  static constexpr T law(T a) {
    static_assert(!A::is_signed && Y::is_signed && Y::frac >= A::frac);
    return law::ones_complement(a, Y::frac - A::frac);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("inverter_bank", "Inverter bank: y_o = -a_i - 1 ulp of y_o, the ones' complement.");
    reader.drive(y_o, law(reader.read(a_i, A{})), Y{});
  }

 private:
  void eval() { y_o.write(law<std::int64_t>(a_i.read().to_int64())); }
};

}  // namespace blysk
