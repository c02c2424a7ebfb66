// SPDX-License-Identifier: Apache-2.0
// Both kinds of register against their next-state tables, for every sequence of three strobes, data and resets.
#include "rtl_sysc/blocks/reg_level.h"
#include "rtl_sysc/blocks/reg_trailing.h"
#include "tb/catch.h"

// SystemC's own objects, compiled by g++, refer to parts of this class that clang leaves out at -O3 otherwise.
template class sc_core::sc_signal<bool>;

namespace {

using namespace blysk;
using data = uq<2, 0>;

struct registers {
  registers() {
    level.clk(clk), level.rst_n(rst_n), level.d_i(d), level.we_i(we), level.q_o(level_q);
    trailing.clk(clk), trailing.rst_n(rst_n), trailing.d_i(d), trailing.we_i(we), trailing.q_o(trailing_q);
  }

  /// New inputs while clk is low.
  void present(bool reset, bool strobe, unsigned value) {
    rst_n.write(!reset);
    we.write(strobe);
    d.write(value);
    sc_core::sc_start(1, sc_core::SC_NS);
  }

  void clock(bool reset, bool strobe, unsigned value) {
    present(reset, strobe, value);
    clk.write(true);
    sc_core::sc_start(1, sc_core::SC_NS);
    clk.write(false);
    sc_core::sc_start(1, sc_core::SC_NS);
  }

  reg_level<data> level{"level"};
  reg_trailing<data> trailing{"trailing"};
  sc_core::sc_signal<bool> clk, rst_n, we;
  sc_core::sc_signal<data::raw_t> d, level_q, trailing_q;
} bench;

TEST_CASE("registers follow their next-state tables", "[unit][reg_level][reg_trailing]") {
  bench.clock(true, false, 3);
  unsigned level = 0;
  unsigned trailing = 0;
  bool before = false;
  // 16 inputs in each of three consecutive cycles: every pair of states that a register can tell apart is met.
  for (unsigned sequence = 0; sequence < 16 * 16 * 16; ++sequence) {
    for (unsigned step = 0; step < 3; ++step) {
      const unsigned input = sequence >> (4 * step) & 15;
      const bool reset = (input & 8) != 0;
      const bool strobe = (input & 4) != 0;
      const unsigned value = input & 3;
      CAPTURE(sequence, step, reset, strobe, value);
      bench.present(reset, strobe, value);
      REQUIRE(bench.level_q.read() == level);  // both are synchronous, their reset too
      REQUIRE(bench.trailing_q.read() == trailing);
      bench.clock(reset, strobe, value);
      if (reset) {
        level = trailing = 0;
        before = false;
      } else {
        if (strobe) level = value;
        if (before && !strobe) trailing = value;
        before = strobe;
      }
      REQUIRE(bench.level_q.read() == level);
      REQUIRE(bench.trailing_q.read() == trailing);
    }
  }
}

TEST_CASE("registers see nothing between two rising edges of clk", "[unit][reg_level][reg_trailing]") {
  const bool strobe =
      GENERATE(false, true);  // as the edges of clk see it; what pulses between them is its opposite
  bench.clock(true, false, 0);
  bench.clock(false, true, 1);
  bench.clock(false, false, 2);  // level holds 1, trailing took 2
  if (strobe) bench.clock(false, true, 1);
  for (const bool clock_high : {false, true}) {
    for (const bool opposite : {true, false, true, false}) {
      bench.d.write(3);
      bench.we.write(strobe != opposite);
      bench.rst_n.write(!opposite);
      sc_core::sc_start(1, sc_core::SC_NS);
      CHECK(bench.level_q.read() == 1u);
      CHECK(bench.trailing_q.read() == 2u);
    }
    bench.d.write(1);
    sc_core::sc_start(1, sc_core::SC_NS);
    if (!clock_high) {
      bench.clk.write(true);
      sc_core::sc_start(1, sc_core::SC_NS);
    }
  }
  bench.clk.write(false);
  bench.clock(false, strobe, 1);
  CHECK(bench.level_q.read() == 1u);
  CHECK(bench.trailing_q.read() == 2u);
}

TEST_CASE("a reset between a strobe's edges cancels the write", "[unit][reg_trailing]") {
  bench.clock(true, false, 0);
  bench.clock(false, true, 3);
  bench.clock(true, true, 3);
  bench.clock(false, false, 3);
  CHECK(bench.trailing_q.read() == 0u);
}

}  // namespace
