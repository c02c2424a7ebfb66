// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Leading-zero counter and shifter: a_i = m_o 2^(-zeros_o - 1) with m_o in [1, 2]; 1 becomes m_o = 2 and zeros_o = 0.
/// For a_i = 0: zero_o is one, m_o = 1 and zeros_o has all ones.
///
/// Instances  norm of the path by a logarithm.
/// Formats    a_i: UQ1.F, codes 0..2^F; m_o: UQ2.(F-1); zeros_o: Count, UQb.0 with 2^b >= F > 2^(b-1).
/// Timing     combinational.   Error  none.
template <int F, class Count>
struct normalise : sc_core::sc_module {
  using a = unit<F>;
  using m = uq<2, F - 1>;
  static_assert(Count::frac == 0 && (1 << Count::width) >= F && (1 << (Count::width - 1)) < F,
                "the zeros above every code have to be counted");

  sc_core::sc_in<typename a::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<typename m::raw_t> SC_NAMED(m_o);
  sc_core::sc_out<typename Count::raw_t> SC_NAMED(zeros_o);
  sc_core::sc_out<bool> SC_NAMED(zero_o);

  SC_CTOR(normalise) {
    SC_METHOD(eval);
    sensitive << a_i;
  }

  /// \return  m_o
  template <class T>
  static constexpr T law(T code, T& zeros, T& is_zero) {
    T moved = code;
    T counted = static_cast<T>(0);
    for (int bit = Count::width - 1; bit >= 0; --bit) {
      const int places = 1 << bit;
      const T is_small = law::is_below_power(moved, F - places);
      moved = law::move_up_within(is_small, moved, places, F);
      counted = counted | law::move_up(is_small, bit);
    }
    zeros = counted;
    is_zero = law::is_below_power(moved, F - 1);
    return moved | law::move_up(is_zero, F - 1);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("normalise", "Normaliser: a_i = m_o 2^(-zeros_o - 1), 1 <= m_o <= 2; zero_o: a_i is 0.");
    auto zeros = reader.constant(0);
    auto is_zero = reader.constant(0);
    const auto mantissa = law(reader.read(a_i, a{}), zeros, is_zero);
    reader.drive(m_o, mantissa, m{});
    reader.drive(zeros_o, zeros, Count{});
    reader.drive(zero_o, is_zero);
  }

 private:
  void eval() {
    std::int64_t zeros = 0;
    std::int64_t is_zero = 0;
    m_o.write(law<std::int64_t>(a_i.read().to_int64(), zeros, is_zero));
    zeros_o.write(zeros);
    zero_o.write(is_zero != 0);
  }
};

}  // namespace blysk
