// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/clocked.h"
#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Shift register that halves: takes d_i / 2, then halves what it holds with each step.
///
/// Instances  rg_shift of [T] fig. 2.13.
/// Formats    d_i: D, q_o: Q with Q::frac > D::frac; what falls below the last place of Q is lost.
/// Timing     q_o changes after the rising edge of clk that saw load_i or step_i at one; load_i has precedence.
/// Reset      rst_n low at a rising edge of clk: 0.
template <class D, class Q>
struct shift_register : sc_core::sc_module {
  static_assert(Q::frac > D::frac);

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(load_i);
  sc_core::sc_in<bool> SC_NAMED(step_i);
  sc_core::sc_in<typename D::raw_t> SC_NAMED(d_i);
  sc_core::sc_out<typename Q::raw_t> SC_NAMED(q_o);

  SC_CTOR(shift_register) {
    BLYSK_CLOCKED(shift);
    SC_METHOD(show);
    sensitive << held;
  }

  /// What the register holds next.
  template <class T>
  static constexpr T law(T load, T d, T q) {
    using law::select;
    return select(load, law::move_up(d, Q::frac - D::frac - 1), law::halve(q));
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("shift_register",
                    "Shift register: takes d_i / 2 while load_i is one, else halves while step_i is.");
    const auto load = reader.read(load_i);
    const auto q = reader.read(held);
    reader.reg(clk, rst_n, load || reader.read(step_i), law(load, reader.read(d_i, D{}), q), held, Q{});
    reader.drive(q_o, q, Q{});
  }

 private:
  BLYSK_CLOCKED_BODY(shift)
  void shift() {
    if (!rst_n.read()) {
      held.write(0);
    } else if (load_i.read() || step_i.read()) {
      held.write(law<std::int64_t>(load_i.read() ? 1 : 0, d_i.read().to_int64(), held.read().to_int64()));
    }
  }
  void show() { q_o.write(held.read()); }

  sc_core::sc_signal<typename Q::raw_t> SC_NAMED(held);
};

}  // namespace blysk
