// SPDX-License-Identifier: Apache-2.0
// The monitor of ranges on devices that are wrong on purpose.
#include <algorithm>
#include <memory>
#include <string>
#include <tuple>

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/constant.h"
#include "rtl_sysc/blocks/reg_level.h"
#include "tb/catch.h"
#include "tb/harness/range_monitor.h"
#include "tb/harness/systemc_engine.h"

namespace {

using namespace blysk;
using harness::net_range;

using operand = uq<4, 0>;

/// An inverter whose law forgets to invert.
struct wrong_inverter : sc_core::sc_module {
  sc_core::sc_in<operand::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<operand::raw_t> SC_NAMED(y_o);

  SC_CTOR(wrong_inverter) {
    SC_METHOD(eval);
    sensitive << a_i;
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("wrong_inverter", "Says that it copies.");
    reader.drive(y_o, reader.read(a_i, operand{}), operand{});
  }

 private:
  void eval() { y_o.write(~a_i.read()); }
};

/// Register 1, then an adder or the inverter.
/// \tparam Sum  of the adder
template <class Sum>
struct adding : sc_core::sc_module {
  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<operand::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<bool> SC_NAMED(a_we_i);
  sc_core::sc_out<typename Sum::raw_t> SC_NAMED(s_o);

  reg_level<operand> SC_NAMED(rg1);
  constant<uq<1, 0>> carry3;
  add<operand, operand, Sum> SC_NAMED(add2);
  sc_core::sc_signal<operand::raw_t> SC_NAMED(a);
  sc_core::sc_signal<uq<1, 0>::raw_t> SC_NAMED(carry);

  SC_CTOR(adding) : carry3("carry3", 1) {
    rg1.clk(clk);
    rg1.rst_n(rst_n);
    rg1.d_i(a_i);
    rg1.we_i(a_we_i);
    rg1.q_o(a);
    carry3.y_o(carry);
    add2.a_i(a);
    add2.b_i(a);
    add2.carry_i(carry);
    add2.s_o(s_o);
  }

  template <class Reader>
  static void pins(Reader& reader) {
    reader.clock(&adding::clk, {"clk", "", "clk", "clock"});
    reader.reset(&adding::rst_n, {"rst_n", "", "rst_n", "synchronous"});
    reader.data(&adding::a_i, {"a_i", "", "a", "to register 1"}, operand{}, "a");
    reader.strobe(&adding::a_we_i, {"a_we_i", "", "a_we", "writes it"}, "a_i", write_edge::level);
    reader.result(&adding::s_o, {"s_o", "", "s", "2 a + 1"}, Sum{}, "s");
  }

  auto blocks() const { return std::tie(rg1, carry3, add2); }
};

struct inverting : sc_core::sc_module {
  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<operand::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<operand::raw_t> SC_NAMED(y_o);

  wrong_inverter SC_NAMED(inv1);

  SC_CTOR(inverting) {
    inv1.a_i(a_i);
    inv1.y_o(y_o);
  }

  template <class Reader>
  static void pins(Reader& reader) {
    reader.clock(&inverting::clk, {"clk", "", "clk", "clock"});
    reader.data(&inverting::a_i, {"a_i", "", "a", "to the inverter"}, operand{}, "a");
    reader.result(&inverting::y_o, {"y_o", "", "y", "its inverse"}, operand{}, "y");
  }

  auto blocks() const { return std::tie(inv1); }
};

net_range find(const harness::range_monitor& of, const std::string& name) {
  const auto found = std::ranges::find(of.ranges(), name, &net_range::name);
  REQUIRE(found != of.ranges().end());
  return *found;
}

void wait_cycles(int cycles) {
  sc_core::sc_start(cycles * harness::kClockPeriodNs, sc_core::SC_NS);
}

}  // namespace

// One case: SystemC elaborates once.
TEST_CASE("the monitor sees a sum before it is cut, and a block that its law does not describe",
          "[harness]") {
  netlist::elaborated wide(std::make_unique<adding<uq<5, 0>>>("wide"), harness::kClockPeriodNs);
  netlist::elaborated narrow(std::make_unique<adding<operand>>("narrow"), harness::kClockPeriodNs);
  netlist::elaborated wrong(std::make_unique<inverting>("wrong"), harness::kClockPeriodNs);
  harness::range_monitor of_wide("of_wide", wide);
  harness::range_monitor of_narrow("of_narrow", narrow);
  harness::range_monitor of_wrong("of_wrong", wrong);
  wait_cycles(2);
  CHECK(of_wide.edges() == 0);
  for (netlist::elaborated* each : {&wide, &narrow}) {
    each->find("rst_n").write(1);
    each->find("a_we_i").write(1);
    each->find("a_i").write(7);
  }
  wait_cycles(2);
  of_wide.watch(true);
  of_narrow.watch(true);
  for (netlist::elaborated* each : {&wide, &narrow}) {
    each->find("a_i").write(3);
    wait_cycles(2);
    each->find("a_i").write(9);
    wait_cycles(2);
    each->find("a_we_i").write(0);
    each->find("a_i").write(15);  // not taken
    wait_cycles(2);
  }
  CHECK(of_wide.edges() == 12);
  for (const harness::range_monitor* each : {&of_wide, &of_narrow}) {
    const net_range sum = find(*each, "add2.s_o");
    CHECK(sum.least == 7);
    CHECK(sum.greatest == 19);
    CHECK(sum.bits_needed() == 5);
    CHECK(sum.holds() == (each == &of_wide));
    const net_range held = find(*each, "rg1.q_o");
    CHECK(held.least == 3);
    CHECK(held.greatest == 9);
    CHECK(held.bits_needed() == 4);
    CHECK(held.holds());
  }
  CHECK(of_wrong.ranges().size() == 1);
  of_wrong.watch(true);
  wrong.find("a_i").write(5);
  wait_cycles(2);
  CHECK_THROWS_WITH(of_wrong.ranges(), "inv1.y_o does not carry what its block's law gives");
}
