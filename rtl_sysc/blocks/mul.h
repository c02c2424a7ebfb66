// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Multiplier: p_o = a_i * b_i, exact when P keeps all fraction bits, else rounded to nearest (ties up).
///
/// Instances  mul6 mul7 mul10 mul12 mul13 mul14 of [P] fig. 1.
/// Formats    a_i: A, b_i: B, p_o: P; the device asserts that no product overflows P.
/// Timing     combinational.
/// Error      0, or 1/2 ulp of P if P::frac < A::frac + B::frac.
template <class A, class B, class P>
struct mul : sc_core::sc_module {
  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<typename B::raw_t> SC_NAMED(b_i);
  sc_core::sc_out<typename P::raw_t> SC_NAMED(p_o);

  SC_CTOR(mul) {
    SC_METHOD(eval);
    sensitive << a_i << b_i;
  }

  using exact = product_of<A, B>;  // what T has to hold

  template <class T>
  static constexpr T law(T a, T b) {
    constexpr int dropped = exact::frac - P::frac;
    static_assert(law::rounds_within(exact::width, dropped), "a product is rounded within 64 bits");
    return law::mul(a, b, dropped, law::has_headroom(exact::width));
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("mul", P::frac == exact::frac
                               ? "Multiplier: p_o = a_i * b_i, exact."
                               : "Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.");
    reader.drive(p_o, law(reader.read(a_i, A{}), reader.read(b_i, B{})), P{});
  }

 private:
  void eval() { p_o.write(law<std::int64_t>(a_i.read().to_int64(), b_i.read().to_int64())); }
};

}  // namespace blysk
