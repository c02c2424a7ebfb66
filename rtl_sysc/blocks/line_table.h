// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// A function from a table by straight lines: y_o = value[i] + slope[i] rest, i the upper bits of a_i, rest the others as a
/// fraction of the distance between two values.
///
/// Instances  line of the arc cosine.
/// Formats    a_i: unit<Frac>, y_o: Y.
/// \tparam Contents  has static constexpr arrays of std::int64_t with 2^Contents::segment_bits + 1 raw words each: `values`,
///                   and `slopes`, from each value to the next, the last one 0
/// Timing     combinational.   Error  that of the lines, and 1/2 ulp of Y.
template <int Frac, class Y, class Contents>
struct line_table : sc_core::sc_module {
  using number = unit<Frac>;
  static constexpr int rest_bits = Frac - Contents::segment_bits;
  static_assert(rest_bits >= 1);

  sc_core::sc_in<typename number::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<typename Y::raw_t> SC_NAMED(y_o);

  SC_CTOR(line_table) {
    SC_METHOD(eval);
    sensitive << a_i;
  }

  template <class T>
  static constexpr T law(T a) {
    using law::lookup;
    const T segment = law::upper_bits(a, rest_bits);
    const T slope = lookup(Contents::slopes, segment);
    return lookup(Contents::values, segment) + law::mul(slope, law::lower_bits(a, rest_bits), rest_bits);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("line_table", "Straight lines between the words of a table, y_o rounded to nearest.");
    reader.drive(y_o, law(reader.read(a_i, number{})), Y{});
  }

 private:
  void eval() { y_o.write(law<std::int64_t>(a_i.read().to_int64())); }
};

}  // namespace blysk
