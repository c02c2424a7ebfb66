// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/clocked.h"
#include "rtl_sysc/qformat.h"

#include <type_traits>

namespace blysk {

/// Registers of a pipeline, one behind the other: q_o is what d_i was so many clock edges with go_i before.
///
/// Instances  pipe_* of the pipelined devices.
/// Formats    d_i, q_o: Q.   Reset  rst_n low at a rising edge of clk: all 0.
/// Timing     the registers go on at each rising edge of clk that sees go_i at one.
template <class Q>
struct pipe : sc_core::sc_module {
  using raw_t = typename Q::raw_t;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(go_i);
  sc_core::sc_in<raw_t> SC_NAMED(d_i);
  sc_core::sc_out<raw_t> SC_NAMED(q_o);

  using SC_CURRENT_USER_MODULE = pipe;  // what SC_METHOD asks for; SystemC 3 deprecates SC_HAS_PROCESS
  /// \param registers  one or more
  pipe(const sc_core::sc_module_name& name, int registers)
      : sc_core::sc_module(name), held("held", static_cast<std::size_t>(registers - 1)) {
    BLYSK_CLOCKED(load);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("pipe", "Registers of a pipeline: d_i moves on by one while go_i is one.",
                    static_cast<int>(held.size()) + 1);
    const auto go = reader.read(go_i);
    auto moved = read_input(reader);
    for (std::size_t i = 0; i < held.size(); ++i) {
      reader.reg(clk, rst_n, go, moved, held[i]);
      moved = reader.read(held[i]);
    }
    if constexpr (std::is_same_v<Q, single_bit>) {
      reader.reg(clk, rst_n, go, moved, q_o);
    } else {
      reader.reg(clk, rst_n, go, moved, q_o, Q{});
    }
  }

 private:
  template <class Reader>
  auto read_input(Reader& reader) const {
    if constexpr (std::is_same_v<Q, single_bit>) {
      return reader.read(d_i);
    } else {
      return reader.read(d_i, Q{});
    }
  }

  BLYSK_CLOCKED_BODY(load)
  void load() {
    if (!rst_n.read()) {
      for (std::size_t i = 0; i < held.size(); ++i) held[i].write(raw_t(0));
      q_o.write(raw_t(0));
    } else if (go_i.read()) {
      for (std::size_t i = 0; i < held.size(); ++i) {
        if (i == 0) {
          held[i].write(d_i.read());
        } else {
          held[i].write(held[i - 1].read());
        }
      }
      if (held.size() == 0) {
        q_o.write(d_i.read());
      } else {
        q_o.write(held[held.size() - 1].read());
      }
    }
  }

  sc_core::sc_vector<sc_core::sc_signal<raw_t>> held;
};

}  // namespace blysk
