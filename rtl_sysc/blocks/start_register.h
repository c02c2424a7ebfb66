// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/clocked.h"
#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Register of an interpolator: a start value, then what an adder makes of it with each step.
///
/// Instances  rg_pixel of the Gouraud interpolator; rg_value, rg_first and rg_second of that by forward differences.
/// Formats    d_i: D, sum_i, q_o: Q with Q::frac >= D::frac.
/// Timing     at a rising edge of clk: while load_i is one q_o becomes d_i; else, while step_i is one, sum_i.
/// Reset      rst_n low at a rising edge of clk: 0.
template <class D, class Q>
struct start_register : sc_core::sc_module {
  static_assert(Q::frac >= D::frac);

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(load_i);
  sc_core::sc_in<bool> SC_NAMED(step_i);
  sc_core::sc_in<typename D::raw_t> SC_NAMED(d_i);
  sc_core::sc_in<typename Q::raw_t> SC_NAMED(sum_i);
  sc_core::sc_out<typename Q::raw_t> SC_NAMED(q_o);

  SC_CTOR(start_register) { BLYSK_CLOCKED(load); }

  /// What the register takes.
  template <class T>
  static constexpr T law(T load, T d, T sum) {
    using law::select;
    return select(load, law::move_up(d, Q::frac - D::frac), sum);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("start_register", "Register of an interpolator: d_i while load_i is one, else sum_i.");
    const auto load = reader.read(load_i);
    reader.reg(clk, rst_n, load || reader.read(step_i),
               law(load, reader.read(d_i, D{}), reader.read(sum_i, Q{})), q_o, Q{});
  }

 private:
  BLYSK_CLOCKED_BODY(load)
  void load() {
    if (!rst_n.read()) {
      q_o.write(0);
    } else if (load_i.read() || step_i.read()) {
      q_o.write(law<std::int64_t>(load_i.read() ? 1 : 0, d_i.read().to_int64(), sum_i.read().to_int64()));
    }
  }
};

}  // namespace blysk
