// SPDX-License-Identifier: Apache-2.0
// An iterative device in SystemC, its ports driven one cycle at a time: latency, starts while it works, results that stay, and
// a reset with a point under way. One process per case: SystemC elaborates once.
#include "tb/specular/iterative.h"

#include <optional>

#include "tb/catch.h"
#include "tb/specular/test/handshake_bench.h"

namespace {

using namespace blysk;
using specular::handshake_bench;
using specular::outputs;

}  // namespace

TEST_CASE("a point takes a cycle for each digit, and one more", "[variants]") {
  handshake_bench bench;
  const selection& asked = bench.asked();
  const int digits =
      asked.fraction() + 2;  // of the quotient: one before the point, and one more than the BRDF has
  REQUIRE(bench.latency() == digits + 1);
  CHECK(asked.of().latency_cycles(asked) == bench.latency());
  CHECK(asked.of().cycles_per_row(asked) == bench.latency());
  for (int point = 0; point < 20; ++point) {
    const std::vector<std::int64_t> codes = bench.random_point();
    bench.put(codes);
    const outputs before = bench.cycle(true);
    CHECK(before.ready);
    CHECK_FALSE(before.valid);
    for (int i = 1; i < bench.latency(); ++i) {
      bench.put(bench.random_point());  // the inputs need not stay
      const outputs seen = bench.cycle(bench.one_in(2));
      CHECK_FALSE(seen.valid);
      CHECK_FALSE(seen.ready);
    }
    const outputs seen = bench.cycle(false);
    CHECK(seen.valid);
    CHECK(seen.ready);
    REQUIRE(seen.results == bench.expected(codes));
    for (int i = 0; i < 3; ++i) {
      bench.put(bench.random_point());
      const outputs after = bench.cycle(false);
      CHECK_FALSE(after.valid);
      CHECK(after.ready);
      CHECK(after.results == seen.results);
    }
  }
}

TEST_CASE("with start at one a point leaves in each cycle that takes one", "[variants]") {
  handshake_bench bench;
  std::optional<std::vector<std::int64_t>> under_way;
  for (int i = 0; i <= 50 * bench.latency(); ++i) {
    const std::vector<std::int64_t> codes = bench.random_point();
    bench.put(codes);
    const outputs seen = bench.cycle(true);
    const bool takes = i % bench.latency() == 0;
    CHECK(seen.ready == takes);
    CHECK(seen.valid == (takes && i > 0));
    if (!takes) continue;
    if (under_way) REQUIRE(seen.results == bench.expected(*under_way));
    under_way = codes;
  }
}

TEST_CASE("with starts and resets at any time each point that was taken leaves once", "[variants]") {
  handshake_bench bench;
  std::optional<std::vector<std::int64_t>> under_way;
  int waited = 0, delivered = 0, lost = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::vector<std::int64_t> codes = bench.random_point();
    bench.put(codes);
    const bool start = bench.one_in(3);
    const bool reset = bench.one_in(100);
    const outputs seen = bench.cycle(start, false, reset);
    if (under_way) ++waited;
    const bool is_due = under_way && waited == bench.latency();
    REQUIRE(seen.valid == is_due);
    REQUIRE(seen.ready == (is_due || !under_way));
    if (is_due) {
      REQUIRE(seen.results == bench.expected(*under_way));
      under_way.reset();
      ++delivered;
    }
    if (reset) {
      lost += under_way ? 1 : 0;
      under_way.reset();
    } else if (start && !under_way) {
      under_way = codes;
      waited = 0;
    }
  }
  // A point takes up to 27 cycles, a reset comes once in a hundred.
  CHECK(delivered > 400);
  CHECK(lost > 50);
}

TEST_CASE("a reset clears the results", "[variants]") {
  handshake_bench bench;
  for (int before = 0; before <= bench.latency(); ++before) {
    bench.put(bench.random_point());
    bench.cycle(true);
    for (int i = 0; i < before; ++i) bench.cycle(false);
    bench.cycle(false, false, true);
    const outputs seen = bench.cycle(false);
    CAPTURE(before);
    CHECK(seen.ready);
    CHECK_FALSE(seen.valid);
    for (const std::int64_t each : seen.results) CHECK(each == 0);
  }
}
