// SPDX-License-Identifier: Apache-2.0
// The strobe protocol of [P] fig. 3 at the pins of the device: SystemC against a behavioural reference that knows
// nothing of clocks inside the device, only what each strobe is said to do.
#include <random>

#include "tb/bench/quadratic_bench.h"
#include "tb/bit/quadratic.h"
#include "tb/catch.h"

namespace {

using namespace blysk;
using formats = quadratic_formats<q8, lobe::clamped>;

constexpr wired_constants kWired = derived_line(formats::slope_bits);

bench::quadratic_pins<formats> pins("pins", kWired);

/// Register contents as the patent's words have them.
struct registers {
  std::uint32_t n = 0, cos_delta = 0, red = 0, green = 0, blue = 0;
};

struct outputs {
  std::int32_t red, green, blue;
  bool operator==(const outputs&) const = default;
};

outputs expected(const registers& r) {
  const auto n = static_cast<std::uint16_t>(r.n);
  const auto red = static_cast<std::uint8_t>(r.red);
  const auto green = static_cast<std::uint8_t>(r.green);
  const auto blue = static_cast<std::uint8_t>(r.blue);
  std::int32_t brdf = 0;
  outputs out{};
  bit::quadratic_vector<formats>(
      kWired, {&n, &r.cos_delta, &red, &green, &blue, &brdf, &out.red, &out.green, &out.blue, 1});
  return out;
}

outputs actual() {
  return {static_cast<std::int32_t>(pins.out25_red.read().to_int64()),
          static_cast<std::int32_t>(pins.out26_green.read().to_int64()),
          static_cast<std::int32_t>(pins.out27_blue.read().to_int64())};
}

struct strobes {
  bool n = false, cos_delta = false, red = false, green = false, blue = false;
};

void put(const registers& data, const strobes& s) {
  pins.n16.write(data.n), pins.strobe15.write(s.n);
  pins.cos18.write(data.cos_delta), pins.strobe17.write(s.cos_delta);
  pins.red19.write(data.red), pins.strobe20.write(s.red);
  pins.green21.write(data.green), pins.strobe22.write(s.green);
  pins.blue23.write(data.blue), pins.strobe24.write(s.blue);
}

/// From one falling edge of clk to the next.
void cycle() {
  sc_core::sc_start(bench::kClockPeriodNs, sc_core::SC_NS);
}

void reset() {
  pins.rst_n.write(false);
  put({}, {});
  if (sc_core::sc_time_stamp() == sc_core::SC_ZERO_TIME) {
    sc_core::sc_start(bench::kClockPeriodNs / 2, sc_core::SC_NS);  // to the first falling edge
  }
  cycle();
  pins.rst_n.write(true);
}

/// Writes all registers, 17 last, and lets the outputs settle.
void load(const registers& data) {
  put(data, {true, true, true, true, true});
  cycle();
  put(data, {});
  cycle();
}

std::uint32_t below(std::mt19937& random, std::uint32_t end) {
  return static_cast<std::uint32_t>(random() % end);
}

constexpr registers kFirst{10, 250, 200, 100, 50};
constexpr registers kSecond{20, 253, 90, 80, 70};

// Nets in raw units of q8: cos has 8 fraction bits, a has 8, cos^2 - cos has 16, the parabola 24.
TEST_CASE("every net of fig. 1 holds its formula", "[unit][netlist]") {
  reset();
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    const registers data{below(random, 1000) + 1, below(random, 257), below(random, 256), below(random, 256),
                         below(random, 256)};
    const std::int64_t n = data.n;
    const std::int64_t c = data.cos_delta;
    load(data);
    const auto& device = pins.device;
    const std::int64_t a = 201 * n - 128;
    const std::int64_t diff = c * c - 256 * c;
    CAPTURE(n, c);
    REQUIRE(device.n.read().to_int64() == n);
    REQUIRE(device.cos_delta.read().to_int64() == c);
    REQUIRE(device.r_ks.read().to_uint() == data.red);
    REQUIRE(device.g_ks.read().to_uint() == data.green);
    REQUIRE(device.b_ks.read().to_uint() == data.blue);
    REQUIRE(device.slope_n.read().to_int64() == 201 * n);
    REQUIRE(device.a.read().to_int64() == a);
    REQUIRE(device.cos2.read().to_int64() == c * c);
    REQUIRE(device.cos_inv.read().to_int64() == -256 * c - 1);
    REQUIRE(device.cos2_minus_cos.read().to_int64() == diff);
    REQUIRE(device.a_times_diff.read().to_int64() == a * diff);
    REQUIRE(device.parabola.read().to_int64() == a * diff + 65536 * c);
    REQUIRE(actual() == expected(data));
  }
}

TEST_CASE("without its strobe no register changes", "[unit][strobe]") {
  reset();
  load(kFirst);
  REQUIRE(actual() == expected(kFirst));
  REQUIRE(actual().red > 0);
  put(kSecond, {});
  for (int i = 0; i < 4; ++i) {
    cycle();
    CHECK(actual() == expected(kFirst));
  }
}

TEST_CASE("each strobe writes its register and no other", "[unit][strobe]") {
  reset();
  load(kFirst);
  registers held = kFirst;
  const auto level = [&](strobes s, std::uint32_t registers::*field) {
    put(kSecond, s);
    held.*field = kSecond.*field;
    cycle();
    CHECK(actual() == expected(held));
    put(kFirst, {});
    cycle();
    CHECK(actual() == expected(held));
  };
  level({.n = true}, &registers::n);
  level({.red = true}, &registers::red);
  level({.green = true}, &registers::green);
  level({.blue = true}, &registers::blue);

  put(kSecond, {.cos_delta = true});
  for (int i = 0; i < 3; ++i) {
    cycle();
    CHECK(actual() == expected(held));  // high, whether for one cycle or for three: nothing is written
  }
  put(kSecond, {});
  held.cos_delta = kSecond.cos_delta;
  cycle();
  CHECK(actual() == expected(held));
}

TEST_CASE("a level strobe follows its data as long as it is at one", "[unit][strobe]") {
  reset();
  load(kFirst);
  registers held = kFirst;
  for (const std::uint32_t red : {1u, 255u, 0u, 7u}) {
    held.red = red;
    put(held, {.red = true});
    cycle();
    CHECK(actual() == expected(held));
  }
}

TEST_CASE("29 is 17, and at its leading edge the outputs belong to the write before", "[unit][strobe]") {
  reset();
  registers before = kFirst;
  load(kFirst);
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i) {
    const registers next{before.n, below(random, 257), before.red, before.green, before.blue};
    put(next, {.cos_delta = true});
    sc_core::sc_start(bench::kClockPeriodNs / 4, sc_core::SC_NS);  // before the rising edge of clk
    CHECK(pins.valid29.read());
    CHECK(actual() == expected(before));
    sc_core::sc_start(bench::kClockPeriodNs * 3 / 4, sc_core::SC_NS);
    put(next, {});
    sc_core::sc_start(bench::kClockPeriodNs / 4, sc_core::SC_NS);
    CHECK_FALSE(pins.valid29.read());
    sc_core::sc_start(bench::kClockPeriodNs * 3 / 4, sc_core::SC_NS);
    before = next;
  }
}

TEST_CASE("pulses between two rising edges of clk write nothing", "[unit][strobe]") {
  reset();
  load(kFirst);
  const bool held = GENERATE(false, true);  // 17 as the edges of clk see it
  put(kFirst, {.cos_delta = held});
  cycle();
  for (int i = 0; i < 3; ++i) {
    // Eighths of a period from one falling edge of clk to the next; the rising edge begins the fifth.
    for (const bool pulse : {true, false, true, false, false, true, false, true}) {
      if (pulse) {
        put(kSecond, {true, !held, true, true, true});
      } else {
        put(kFirst, {.cos_delta = held});
      }
      sc_core::sc_start(bench::kClockPeriodNs / 8, sc_core::SC_NS);
      CHECK(pins.device.n.read() == kFirst.n);
      CHECK(pins.device.cos_delta.read() == kFirst.cos_delta);
      CHECK(actual() == expected(kFirst));
    }
  }
}

TEST_CASE("reset in mid-operation clears every register and any pending write", "[unit][strobe]") {
  reset();
  load(kFirst);
  REQUIRE(actual() == expected(kFirst));
  put(kSecond, {true, true, true, true, true});
  cycle();
  pins.rst_n.write(false);
  cycle();
  CHECK(actual() == outputs{0, 0, 0});
  pins.rst_n.write(true);
  put(kSecond, {});
  cycle();
  CHECK(actual() == outputs{0, 0, 0});
  CHECK(pins.device.n.read() == 0u);
  CHECK(pins.device.cos_delta.read() == 0u);  // 17 fell, but its leading edge was before the reset
  load(kSecond);
  CHECK(actual() == expected(kSecond));
}

// A sequence of random strobes and data, several at once, back to back and far apart, and resets, against the words:
// level registers take their data while their strobe is at one, register 2 takes it when 17 has fallen.
TEST_CASE("random strobes do what the patent's words say", "[unit][strobe]") {
  reset();
  std::mt19937 random(60553);
  registers held, data;
  bool strobe17 = false;
  for (int i = 0; i < 20000; ++i) {
    const strobes s{random() % 4 == 0, random() % 2 == 0, random() % 4 == 0, random() % 4 == 0,
                    random() % 4 == 0};
    const bool in_reset = random() % 64 == 0;
    if (random() % 2 == 0) {
      data = {below(random, 1000) + 1, below(random, 257), below(random, 256), below(random, 256),
              below(random, 256)};
    }
    put(data, s);
    pins.rst_n.write(!in_reset);
    cycle();
    if (in_reset) {
      held = {};
      strobe17 = false;
    } else {
      if (s.n) held.n = data.n;
      if (s.red) held.red = data.red;
      if (s.green) held.green = data.green;
      if (s.blue) held.blue = data.blue;
      if (strobe17 && !s.cos_delta) held.cos_delta = data.cos_delta;
      strobe17 = s.cos_delta;
    }
    CAPTURE(i, held.n, held.cos_delta, held.red);
    REQUIRE(pins.device.n.read() == held.n);
    REQUIRE(pins.device.cos_delta.read() == held.cos_delta);
    REQUIRE(pins.device.r_ks.read() == held.red);
    REQUIRE(pins.device.g_ks.read() == held.green);
    REQUIRE(pins.device.b_ks.read() == held.blue);
    REQUIRE(pins.valid29.read() == s.cos_delta);
    if (held.n != 0) REQUIRE(actual() == expected(held));  // 0, after a reset, is no legal exponent
  }
}

}  // namespace
