// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/clocked.h"
#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Gives the digits of a number one after the other, the first with the load itself.
///
/// Instances  rg_digits, which feeds the digits i_j of [T] (2.18) to the accumulating adder of fig. 2.13.
/// Formats    d_i: D unsigned, digit_o: one bit.
/// Timing     digit_o is the first digit of d_i while load_i is one, else the next one of the number that was loaded; the
///            register goes on at each rising edge of clk that sees load_i or step_i at one.
/// Reset      rst_n low at a rising edge of clk: all digits 0.
template <class D>
struct digit_register : sc_core::sc_module {
  static_assert(!D::is_signed);

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(load_i);
  sc_core::sc_in<bool> SC_NAMED(step_i);
  sc_core::sc_in<typename D::raw_t> SC_NAMED(d_i);
  sc_core::sc_out<bool> SC_NAMED(digit_o);

  SC_CTOR(digit_register) {
    BLYSK_CLOCKED(shift);
    SC_METHOD(eval);
    sensitive << load_i << d_i << held;
  }

  template <class T>
  static constexpr T digit(T load, T d, T q) {
    using law::select;
    return law::first_bit(select(load, d, q), D::width);
  }
  template <class T>
  static constexpr T rest(T load, T d, T q) {
    using law::select;
    return law::other_bits(select(load, d, q), D::width);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("digit_register",
                    "Digit register: the digits of d_i one after the other, the first while load_i is one.");
    const auto load = reader.read(load_i);
    const auto d = reader.read(d_i, D{});
    const auto q = reader.read(held);
    reader.reg(clk, rst_n, load || reader.read(step_i), rest(load, d, q), held, D{});
    reader.drive(digit_o, digit(load, d, q));
  }

 private:
  BLYSK_CLOCKED_BODY(shift)
  void shift() {
    if (!rst_n.read()) {
      held.write(0);
    } else if (load_i.read() || step_i.read()) {
      held.write(rest<std::int64_t>(load_i.read() ? 1 : 0, d_i.read().to_int64(), held.read().to_int64()));
    }
  }
  void eval() {
    digit_o.write(digit<std::int64_t>(load_i.read() ? 1 : 0, d_i.read().to_int64(), held.read().to_int64()) !=
                  0);
  }

  sc_core::sc_signal<typename D::raw_t> SC_NAMED(held);
};

}  // namespace blysk
