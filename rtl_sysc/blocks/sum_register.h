// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/clocked.h"
#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Register of an accumulating adder, whose combinational adder forms sum_i from q_o.
///
/// Instances  rg_sum of [T] fig. 2.13.
/// Formats    d_i: D, sum_i, q_o: Q with Q::frac >= D::frac.
/// Timing     at a rising edge of clk: while load_i is one q_o becomes d_i, or 0 if add_i is zero; else, while step_i and
///            add_i are one, sum_i.
/// Reset      rst_n low at a rising edge of clk: 0.
template <class D, class Q>
struct sum_register : sc_core::sc_module {
  static_assert(Q::frac >= D::frac);

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(load_i);
  sc_core::sc_in<bool> SC_NAMED(step_i);
  sc_core::sc_in<bool> SC_NAMED(add_i);
  sc_core::sc_in<typename D::raw_t> SC_NAMED(d_i);
  sc_core::sc_in<typename Q::raw_t> SC_NAMED(sum_i);
  sc_core::sc_out<typename Q::raw_t> SC_NAMED(q_o);

  SC_CTOR(sum_register) { BLYSK_CLOCKED(accumulate); }

  /// What the register takes.
  template <class T>
  static constexpr T law(T load, T add, T d, T sum) {
    using law::select;
    return select(load, select(add, law::move_up(d, Q::frac - D::frac), static_cast<T>(0)), sum);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("sum_register",
                    "Register of an accumulating adder: d_i or 0 while load_i is one, else sum_i.");
    const auto load = reader.read(load_i);
    const auto add = reader.read(add_i);
    reader.reg(clk, rst_n, load || (reader.read(step_i) && add),
               law(load, add, reader.read(d_i, D{}), reader.read(sum_i, Q{})), q_o, Q{});
  }

 private:
  BLYSK_CLOCKED_BODY(accumulate)
  void accumulate() {
    if (!rst_n.read()) {
      q_o.write(0);
    } else if (load_i.read() || (step_i.read() && add_i.read())) {
      q_o.write(law<std::int64_t>(load_i.read() ? 1 : 0, add_i.read() ? 1 : 0, d_i.read().to_int64(),
                                  sum_i.read().to_int64()));
    }
  }
};

}  // namespace blysk
