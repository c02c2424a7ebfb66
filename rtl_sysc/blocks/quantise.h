// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// What a quantise block does with a value outside the range of its result.
enum class overflow {
  excluded,  ///< cannot happen; the device asserts it
  clamp      ///< the nearest end of the range is taken
};

/// Rounds a_i to the fraction bits of Y, to nearest (ties towards +infinity), and clamps it to Y's range if asked.
///
/// Instances  quant11, between adder 11 and multipliers 12..14 of [P] fig. 1 (the figure has none: it does not say
///            how wide its wires are; the clamp is spec erratum E4).
/// Formats    a_i: A, y_o: Y with Y::frac <= A::frac.
/// Timing     combinational.   Error  1/2 ulp of Y; clamping to [0, 1] adds none to a value meant to lie there.
template <class A, class Y, overflow Overflow>
struct quantise : sc_core::sc_module {
  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<typename Y::raw_t> SC_NAMED(y_o);

  SC_CTOR(quantise) {
    SC_METHOD(eval);
    sensitive << a_i;
  }

  template <class T>
  static constexpr T law(T a) {
    if constexpr (Overflow == overflow::clamp && !A::is_signed && Y::min == 0) {
      return law::smaller(rounded<T>(a), T(Y::max));
    } else if constexpr (Overflow == overflow::clamp) {
      return law::clamp(rounded<T>(a), T(Y::min), T(Y::max));
    } else {
      return rounded<T>(a);
    }
  }

  template <class Reader>
  void describe(Reader& reader) const {
    if constexpr (Overflow == overflow::clamp) {
      reader.block_is("quantise", "Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.",
                      "clamp");
    } else {
      reader.block_is("quantise", "Rounds a_i to nearest, ties up.");
    }
    reader.drive(y_o, law(reader.read(a_i, A{})), Y{});
  }

 private:
  template <class T>
  static constexpr T rounded(T a) {
    constexpr int dropped = A::frac - Y::frac;
    static_assert(law::rounds_within(A::width, dropped), "a number is rounded within 64 bits");
    return law::round_off(a, dropped, law::has_headroom(A::width));
  }

  void eval() { y_o.write(law<std::int64_t>(a_i.read().to_int64())); }
};

}  // namespace blysk
