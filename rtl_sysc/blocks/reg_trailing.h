// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/clocked.h"
#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Register written by the trailing edge of its strobe, sampled on clk.
///
/// Instances  rg2 of [P] fig. 1, fig. 3.
/// Formats    d_i, q_o: Q.   Reset  rst_n low at a rising edge of clk: 0, and no edge is pending.
/// Timing     q_o changes after the rising edge of clk that saw we_i at zero when the one before saw it at one;
///            d_i has to hold until then. Pulses between two rising edges of clk are not seen.
template <class Q>
struct reg_trailing : sc_core::sc_module {
  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<typename Q::raw_t> SC_NAMED(d_i);
  sc_core::sc_in<bool> SC_NAMED(we_i);
  sc_core::sc_out<typename Q::raw_t> SC_NAMED(q_o);

  SC_CTOR(reg_trailing) { BLYSK_CLOCKED(load); }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("reg_trailing", "Register: takes d_i by the trailing edge of we_i, as clk samples it.");
    const auto we = reader.read(we_i);
    reader.reg(clk, rst_n, reader.constant(1), we, we_q);
    reader.reg(clk, rst_n, law::trailing_edge(we, reader.read(we_q)), reader.read(d_i, Q{}), q_o, Q{});
  }

 private:
  BLYSK_CLOCKED_BODY(load)
  void load() {
    if (!rst_n.read()) {
      q_o.write(0);
      we_q.write(false);
    } else {
      we_q.write(we_i.read());
      if (law::trailing_edge(we_i.read(), we_q.read())) {
        q_o.write(d_i.read());
      }
    }
  }

  sc_core::sc_signal<bool> SC_NAMED(we_q);  // 17 as the last rising edge of clk saw it
};

}  // namespace blysk
