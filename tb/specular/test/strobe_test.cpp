// SPDX-License-Identifier: Apache-2.0
// The strobe protocol of [P] fig. 3 at the ports of a device: SystemC against a behavioural reference that knows nothing of
// clocks inside the device, only what each strobe is said to do. One process per case: SystemC elaborates once.
#include <random>

#include "tb/catch.h"
#include "tb/devices/test/asked.h"
#include "tb/specular/test/bench.h"

namespace {

using namespace blysk;
using namespace blysk::specular;
using namespace blysk::specular::test;

bench make_bench() {
  return bench(blysk::test::asked_for());
}

/// The same numbers in every format: cos in 1/256.
codes scaled(const bench& of, codes data) {
  data[kCos] <<= of.asked().fraction() - 8;
  return data;
}
codes first_of(const bench& of) {
  return scaled(of, {10, 250, 200, 100, 50});
}
codes second_of(const bench& of) {
  return scaled(of, {20, 253, 90, 80, 70});
}

std::int64_t code(std::mt19937_64& random, const wire_format& format) {
  const auto codes = static_cast<std::uint64_t>(format.max - format.min + 1);
  return format.min + static_cast<std::int64_t>(random() % codes);
}
codes legal(std::mt19937_64& random, const bench& of) {
  codes data{};
  for (std::size_t i = 0; i < kRegisters; ++i) data.at(i) = code(random, of.format(i));
  return data;
}

}  // namespace

TEST_CASE("without its strobe no register changes") {
  bench pins = make_bench();
  const codes first = first_of(pins);
  pins.reset();
  pins.load(first);
  REQUIRE(pins.actual() == pins.expected(first));
  REQUIRE(pins.actual() != pins.expected(second_of(pins)));
  REQUIRE(pins.actual()[kOutRed] > 0);
  pins.put(second_of(pins), kNone);
  for (int i = 0; i < 4; ++i) {
    bench::cycle();
    CHECK(pins.actual() == pins.expected(first));
    CHECK(pins.held() == first);
  }
}

TEST_CASE("each strobe writes its register and no other") {
  bench pins = make_bench();
  const codes first = first_of(pins);
  const codes second = second_of(pins);
  pins.reset();
  pins.load(first);
  codes held = first;
  for (const std::size_t column : {kN, kRed, kGreen, kBlue}) {
    CAPTURE(column);
    pins.put(second, only(column));
    REQUIRE(second.at(column) != held.at(column));
    const auto before = pins.expected(held);
    held.at(column) = second.at(column);
    REQUIRE(pins.expected(held) != before);
    bench::cycle();
    CHECK(pins.held() == held);
    pins.put(first, kNone);
    pins.settle();
    CHECK(pins.actual() == pins.expected(held));
    bench::cycle();
    CHECK(pins.actual() == pins.expected(held));
    CHECK(pins.held() == held);
  }
  pins.put(second, only(kCos));
  for (int i = 0; i < 3; ++i) {
    bench::cycle();
    CHECK(pins.actual() ==
          pins.expected(held));  // high, whether for one cycle or for three: nothing is written
  }
  pins.put(second, kNone);
  const auto before = pins.expected(held);
  held[kCos] = second[kCos];
  REQUIRE(pins.expected(held) != before);
  bench::cycle();
  CHECK(pins.held() == held);
  pins.settle();
  CHECK(pins.actual() == pins.expected(held));
}

TEST_CASE("a level strobe follows its data as long as it is at one") {
  bench pins = make_bench();
  codes held = first_of(pins);
  pins.reset();
  pins.load(held);
  for (const std::int64_t red : {1, 255, 0, 7}) {
    held[kRed] = red;
    pins.put(held, only(kRed));
    bench::cycle();
    CHECK(pins.held() == held);
    pins.settle();
    CHECK(pins.actual() == pins.expected(held));
  }
}

TEST_CASE("29 is 17 and at its leading edge the outputs belong to the write before") {
  bench pins = make_bench();
  codes before = first_of(pins);
  pins.reset();
  pins.load(before);
  std::mt19937_64 random(1);
  for (int i = 0; i < 50; ++i) {
    codes next = before;
    next[kCos] = code(random, pins.format(kCos));
    pins.put(next, only(kCos));
    bench::wait(2);  // before the rising edge of clk
    CHECK(pins.valid());
    CHECK(pins.actual() == pins.expected(before));
    bench::wait(6);
    pins.put(next, kNone);
    bench::wait(2);
    CHECK_FALSE(pins.valid());
    bench::wait(6);
    pins.settle();
    before = next;
  }
}

TEST_CASE("pulses between two rising edges of clk write nothing") {
  bench pins = make_bench();
  const codes first = first_of(pins);
  pins.reset();
  for (const bool level : {false, true}) {  // 17 as the edges of clk see it
    strobes seen = kNone;
    seen[kCos] = level;
    strobes opposite = kAll;
    opposite[kCos] = !level;
    pins.load(first);
    pins.put(first, seen);
    bench::cycle();
    for (int i = 0; i < 3; ++i) {
      // Eighths of a period from one falling edge of clk to the next; the rising edge begins the fifth.
      for (const bool pulse : {true, false, true, false, false, true, false, true}) {
        if (pulse) {
          pins.put(second_of(pins), opposite);
        } else {
          pins.put(first, seen);
        }
        bench::wait(1);
        CHECK(pins.held() == first);
        CHECK(pins.actual() == pins.expected(first));
      }
    }
    pins.put(first, kNone);
    bench::cycle();
  }
}

TEST_CASE("reset in mid-operation clears every register and any pending write") {
  bench pins = make_bench();
  const codes first = first_of(pins);
  const codes second = second_of(pins);
  const auto is_cleared = [&] {
    const auto outputs = pins.actual();
    return outputs[kOutRed] == 0 && outputs[kOutGreen] == 0 && outputs[kOutBlue] == 0 &&
           pins.held() == codes{};
  };
  pins.reset();
  pins.load(first);
  REQUIRE(pins.actual() == pins.expected(first));
  REQUIRE_FALSE(is_cleared());
  pins.put(second, kAll);
  bench::cycle();
  pins.put_reset(true);
  bench::cycle();
  CHECK(is_cleared());
  pins.put_reset(false);
  pins.put(second, kNone);
  bench::cycle();
  CHECK(is_cleared());  // 17 fell, but its leading edge was before the reset
  pins.load(second);
  CHECK(pins.actual() == pins.expected(second));
}

// A sequence of random strobes and data, several at once, back to back and far apart, and resets, against the words:
// level registers take their data while their strobe is at one, register 2 takes it when 17 has fallen.
TEST_CASE("random strobes do what the words of the patent say") {
  bench pins = make_bench();
  pins.reset();
  std::mt19937_64 random(60553);
  codes held{};
  codes data{};
  bool strobe17 = false;
  int unchanged = 0;  // cycles since a register last changed
  int compared = 0;
  for (int i = 0; i < 20000; ++i) {
    strobes levels{};
    for (std::size_t column = 0; column < kRegisters; ++column)
      levels.at(column) = random() % (column == kCos ? 2 : 4) == 0;
    const bool in_reset = random() % 64 == 0;
    if (random() % 2 == 0) data = legal(random, pins);
    pins.put(data, levels);
    pins.put_reset(in_reset);
    bench::cycle();
    const codes before = held;
    for (std::size_t column = 0; column < kRegisters; ++column) {
      if (column == kCos) continue;
      if (levels.at(column)) held.at(column) = data.at(column);
    }
    if (strobe17 && !levels[kCos]) held[kCos] = data[kCos];
    strobe17 = levels[kCos];
    if (in_reset) {
      held = {};
      strobe17 = false;
    }
    CAPTURE(i, held[kN], held[kCos], held[kRed]);
    REQUIRE(pins.held() == held);
    REQUIRE(pins.valid() == levels[kCos]);
    unchanged = held == before ? unchanged + 1 : 0;
    if (unchanged < pins.settling_cycles()) continue;
    if (!pins.is_legal(held)) continue;  // 0, after a reset, may be no legal code
    REQUIRE(pins.actual() == pins.expected(held));
    ++compared;
  }
  CHECK(compared > (pins.settling_cycles() == 0 ? 10000 : 1000));
}
