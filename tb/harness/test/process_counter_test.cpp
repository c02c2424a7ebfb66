// SPDX-License-Identifier: Apache-2.0
// Processes that count their own runs, against the counter from outside.
#include "tb/harness/process_counter.h"

#include <random>
#include <systemc>

#include "tb/catch.h"

// SystemC's own objects, compiled by g++, refer to parts of this class that clang leaves out at -O3 otherwise.
template class sc_core::sc_signal<bool>;

namespace {

using namespace blysk;
using sc_dt::sc_int;
using sc_dt::sc_uint;

/// A leaf block: s = a + b, one process sensitive to both.
struct adder : sc_core::sc_module {
  sc_core::sc_in<sc_uint<5>> SC_NAMED(a_i);
  sc_core::sc_in<sc_uint<5>> SC_NAMED(b_i);
  sc_core::sc_out<sc_int<7>> SC_NAMED(s_o);
  std::uint64_t runs = 0;

  SC_CTOR(adder) {
    SC_METHOD(eval);
    sensitive << a_i << b_i;
  }
  void eval() {
    ++runs;
    s_o.write(sc_int<7>(a_i.read().to_int() + b_i.read().to_int() - 20));
  }
};

/// A register with a control of its own: two processes, one of them sensitive to a signal inside.
struct held : sc_core::sc_module {
  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<sc_int<7>> SC_NAMED(d_i);
  sc_core::sc_out<sc_uint<5>> SC_NAMED(q_o);
  sc_core::sc_out<bool> SC_NAMED(odd_o);
  sc_core::sc_signal<sc_int<7>> SC_NAMED(q);
  std::uint64_t loads = 0, shows = 0;

  SC_CTOR(held) {
    SC_METHOD(load);
    sensitive << clk.pos();
    dont_initialize();
    SC_METHOD(show);
    sensitive << q;
  }
  void load() {
    ++loads;
    q.write(d_i.read());
  }
  void show() {
    ++shows;
    q_o.write(sc_uint<5>(q.read().to_int() & 31));
    odd_o.write((q.read().to_int() & 1) != 0);
  }
};

/// What a bench does: it writes signals that no port of it is bound to.
struct bench : sc_core::sc_module {
  sc_core::sc_signal<sc_uint<5>>& a;
  const sc_core::sc_signal<bool>& odd;
  sc_core::sc_signal<bool> SC_NAMED(turn);
  std::mt19937_64 bits{1};
  std::uint64_t drives = 0, rises = 0, both = 0, together = 0;

  bench(const sc_core::sc_module_name& name, const sc_core::sc_clock& clk, sc_core::sc_signal<sc_uint<5>>& to,
        const sc_core::sc_signal<bool>& from)
      : sc_core::sc_module(name), a(to), odd(from) {
    SC_METHOD(drive);
    sensitive << clk.negedge_event();
    dont_initialize();
    SC_METHOD(rise);
    sensitive << odd.posedge_event();
    dont_initialize();
    SC_METHOD(any);
    sensitive << odd << clk;
    SC_METHOD(once);
    sensitive << a << turn;
  }
  using SC_CURRENT_USER_MODULE = bench;

  void drive() {
    ++drives;
    a.write(sc_uint<5>(bits() % 3));  // the same again in a third of the cycles
    turn.write(!turn.read());
  }
  void rise() { ++rises; }
  void any() { ++both; }
  void once() { ++together; }  // for two signals that change at one time
};

void run(double ns) {
  sc_core::sc_start(sc_core::sc_time(ns, sc_core::SC_NS));
}

}  // namespace

// One case: SystemC elaborates once in a process.
TEST_CASE("the runs of processes are counted from outside", "[harness][processes]") {
  sc_core::sc_clock clk("clk", sc_core::sc_time(10, sc_core::SC_NS));
  sc_core::sc_signal<sc_uint<5>> a("a"), q("q");
  sc_core::sc_signal<sc_int<7>> sum("sum");
  sc_core::sc_signal<bool> odd("odd");
  adder add("add");
  add.a_i(a);
  add.b_i(q);
  add.s_o(sum);
  held rg("rg");
  rg.clk(clk);
  rg.d_i(sum);
  rg.q_o(q);
  rg.odd_o(odd);
  bench host("host", clk, a, odd);
  harness::process_counter counter;
  harness::process_counter thorough;
  thorough.look_at_all();
  CHECK(counter.runs() == 0);

  std::uint64_t edges = 0;
  const auto check = [&] {
    for (const harness::process_counter* each : {&counter, &thorough}) {
      CHECK(each->runs("add.eval") == add.runs);
      CHECK(each->runs("rg.load") == rg.loads);
      CHECK(each->runs("rg.show") == rg.shows);
      CHECK(each->runs("host.drive") == host.drives);
      CHECK(each->runs("host.rise") == host.rises);
      CHECK(each->runs("host.any") == host.both);
      CHECK(each->runs("host.once") == host.together);
      // One process of the clock for each edge.
      CHECK(each->runs() ==
            add.runs + rg.loads + rg.shows + host.drives + host.rises + host.both + host.together + edges);
    }
  };
  run(1);
  edges = 1;
  check();
  run(1000);
  edges += 200;
  check();
  CHECK(rg.loads == 101);
  CHECK(host.drives == 100);
  // From outside, between two runs and at one time: the signal that changed last is not counted again.
  a.write(31);
  run(1);
  check();
  a.write(30);
  a.write(31);
  run(1);
  check();
  const std::uint64_t before = add.runs;
  a.write(7);
  run(1);
  check();
  CHECK(add.runs == before + 1);
  // In the same delta cycle as an edge of the clock, that at 1010 ns: what happens at its end is left to the next run.
  run(6);
  a.write(11);
  run(1000);
  edges += 201;
  check();
  // Some cycles changed nothing.
  CHECK(add.runs > 200);
  CHECK(host.rises > 10);
  CHECK(host.rises < rg.loads / 2);
  CHECK(host.both < 2 * edges);
  CHECK_THROWS_AS(counter.runs("add.no_such"), std::out_of_range);
}
