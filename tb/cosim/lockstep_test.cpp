// SPDX-License-Identifier: Apache-2.0
// The SystemC device and its exported Verilog side by side under the same strobes, compared after every clock edge.
#include "tb/bench/quadratic_bench.h"
#include "tb/catch.h"
#include "tb/cosim/strobes.h"
#include "tb/cosim/vectors.h"
#include "tb/cosim/verilator_engine.h"

namespace blysk::cosim {
namespace {

template <class Q>
void lockstep(const std::string& format, codes which) {
  using formats = quadratic_formats<Q, lobe::clamped>;
  device_options options;
  options.format = format;
  bench::quadratic_pins<formats> systemc("pins", wire_constants(options));
  const auto verilog = make_verilator(options);
  strobe_sequence strobes(Q::frac, which);
  const sc_core::sc_time half = systemc.clk.period() / 2;
  const sc_core::sc_time settle = half / 4;
  pins values;
  int writes_to_outputs = 0;
  outputs before;

  const auto compare = [&](bool clk) {
    values.clk = clk;
    REQUIRE(systemc.clk.read() == clk);
    const outputs got = verilog->apply(values);
    const outputs expected{systemc.out25_red.read().to_uint64(), systemc.out26_green.read().to_uint64(),
                           systemc.out27_blue.read().to_uint64(), systemc.valid29.read()};
    CAPTURE(sc_core::sc_time_stamp().to_string(), got.r_o, expected.r_o, got.g_o, expected.g_o, got.b_o,
            expected.b_o, got.valid_o, expected.valid_o);
    REQUIRE(got == expected);
    writes_to_outputs += got.r_o != before.r_o;
    before = got;
  };

  sc_core::sc_start(half / 2 + settle);  // clk is at one, and away from its edges
  for (int cycle = 0; cycle < kStrobeCycles; ++cycle) {
    sc_core::sc_start(half - settle);
    values = strobes.next(values);
    systemc.rst_n.write(values.rst_n);
    systemc.n16.write(values.n_i);
    systemc.strobe15.write(values.n_we_i);
    systemc.cos18.write(values.cos_i);
    systemc.strobe17.write(values.cos_we_i);
    systemc.red19.write(values.r_i);
    systemc.strobe20.write(values.r_we_i);
    systemc.green21.write(values.g_i);
    systemc.strobe22.write(values.g_we_i);
    systemc.blue23.write(values.b_i);
    systemc.strobe24.write(values.b_we_i);
    sc_core::sc_start(settle);
    compare(false);
    sc_core::sc_start(half);
    compare(true);
  }
  CHECK(writes_to_outputs > kStrobeCycles / 100);  // most inputs lie beyond the lobe, and some writes do not
}

}  // namespace

TEST_CASE("both engines count the same cycles and writes", "[cosim]") {
  device_options options;
  options.format = "q8";
  const auto systemc = bench::make_systemc(options);
  const auto verilog = make_verilator(options);
  results got, expected;
  for (const unsigned rows : {3u, 1u, 1000u}) {
    for_random_inputs(8, rows, rows, [&](const batch& in) {
      systemc->run(in, expected);
      verilog->run(in, got);
    });
    CHECK(got == expected);
    CHECK(verilog->cycles() == systemc->cycles());
    CHECK(verilog->writes() == systemc->writes());
  }
}

// A process elaborates one device: ctest runs each case in its own.
TEST_CASE("q8", "[cosim]") {
  lockstep<q8>("q8", codes::legal);
}
TEST_CASE("q8 with illegal codes", "[cosim]") {
  lockstep<q8>("q8", codes::all);
}
TEST_CASE("q10", "[cosim]") {
  lockstep<q10>("q10", codes::legal);
}
TEST_CASE("q10 with illegal codes", "[cosim]") {
  lockstep<q10>("q10", codes::all);
}
TEST_CASE("q12", "[cosim]") {
  lockstep<q12>("q12", codes::legal);
}
TEST_CASE("q12 with illegal codes", "[cosim]") {
  lockstep<q12>("q12", codes::all);
}
TEST_CASE("q14", "[cosim]") {
  lockstep<q14>("q14", codes::legal);
}
TEST_CASE("q14 with illegal codes", "[cosim]") {
  lockstep<q14>("q14", codes::all);
}
TEST_CASE("q16", "[cosim]") {
  lockstep<q16>("q16", codes::legal);
}
TEST_CASE("q16 with illegal codes", "[cosim]") {
  lockstep<q16>("q16", codes::all);
}
TEST_CASE("q18", "[cosim]") {
  lockstep<q18>("q18", codes::legal);
}
TEST_CASE("q18 with illegal codes", "[cosim]") {
  lockstep<q18>("q18", codes::all);
}
TEST_CASE("q20", "[cosim]") {
  lockstep<q20>("q20", codes::legal);
}
TEST_CASE("q20 with illegal codes", "[cosim]") {
  lockstep<q20>("q20", codes::all);
}
TEST_CASE("q22", "[cosim]") {
  lockstep<q22>("q22", codes::legal);
}
TEST_CASE("q22 with illegal codes", "[cosim]") {
  lockstep<q22>("q22", codes::all);
}
TEST_CASE("q24", "[cosim]") {
  lockstep<q24>("q24", codes::legal);
}
TEST_CASE("q24 with illegal codes", "[cosim]") {
  lockstep<q24>("q24", codes::all);
}

}  // namespace blysk::cosim
