// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Barrel shifter: y_o = a_i 2^(-places_i), what falls below the last place is lost.
///
/// Instances  shift of the path by a logarithm.
/// Formats    a_i, y_o: A unsigned; places_i: Places, an unsigned integer.
/// Timing     combinational.   Error  below 1 ulp, downwards.
template <class A, class Places>
struct shift_right : sc_core::sc_module {
  static_assert(!A::is_signed && !Places::is_signed && Places::frac == 0 && Places::width <= 6);

  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<typename Places::raw_t> SC_NAMED(places_i);
  sc_core::sc_out<typename A::raw_t> SC_NAMED(y_o);

  SC_CTOR(shift_right) {
    SC_METHOD(eval);
    sensitive << a_i << places_i;
  }

  template <class T>
  static constexpr T law(T a, T places) {
    using law::select;
    T moved = a;
    for (int bit = 0; bit < Places::width; ++bit) {
      const T is_moved = law::lower_bits(law::upper_bits(places, bit), 1);
      moved = select(is_moved, law::upper_bits(moved, 1 << bit), moved);
    }
    return moved;
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("shift_right", "Barrel shifter: y_o = a_i moved down by places_i.");
    const auto places = reader.read(places_i, Places{});
    reader.drive(y_o, law(reader.read(a_i, A{}), places), A{});
  }

 private:
  void eval() { y_o.write(law<std::int64_t>(a_i.read().to_int64(), places_i.read().to_int64())); }
};

}  // namespace blysk
