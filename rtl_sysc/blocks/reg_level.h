// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/clocked.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Register written while its strobe is at logic one, sampled on clk.
///
/// Instances  rg1 rg3 rg4 rg5 of [P] fig. 1.
/// Formats    d_i, q_o: Q.   Reset  rst_n low at a rising edge of clk: 0.
/// Timing     q_o changes after the rising edge of clk that saw we_i at one.
template <class Q>
struct reg_level : sc_core::sc_module {
  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<typename Q::raw_t> SC_NAMED(d_i);
  sc_core::sc_in<bool> SC_NAMED(we_i);
  sc_core::sc_out<typename Q::raw_t> SC_NAMED(q_o);

  SC_CTOR(reg_level) { BLYSK_CLOCKED(load); }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("reg_level", "Register: takes d_i while we_i is one.");
    reader.reg(clk, rst_n, reader.read(we_i), reader.read(d_i, Q{}), q_o, Q{});
  }

 private:
  BLYSK_CLOCKED_BODY(load)
  void load() {
    if (!rst_n.read()) {
      q_o.write(0);
    } else if (we_i.read()) {
      q_o.write(d_i.read());
    }
  }
};

}  // namespace blysk
