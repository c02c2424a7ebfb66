// SPDX-License-Identifier: Apache-2.0
// The Gouraud interpolator against the straight line between its ends.
#include <algorithm>
#include <cmath>

#include "tb/catch.h"
#include "tb/device.h"
#include "tb/harness/systemc_engine.h"

namespace {

using namespace blysk;

struct line {
  int length;
  int left[3];
  int right[3];
};

columns rows_of(const selection& asked, const std::vector<line>& lines) {
  columns in(asked.of().ports(asked), port::role::data);
  in.resize(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    in[0].set(i, lines[i].length);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      in[1 + channel].set(i, lines[i].left[channel]);
      in[4 + channel].set(i, lines[i].right[channel]);
    }
  }
  return in;
}

/// Levels of one channel of one line.
std::vector<int> drawn(const std::string& format, const line& wanted, std::size_t channel) {
  const selection asked = choose("gouraud", format);
  columns out;
  asked.of().make_bit(asked)->run(rows_of(asked, {wanted}), out);
  std::vector<int> levels(out.size());
  for (std::size_t i = 0; i < levels.size(); ++i) levels[i] = static_cast<int>(out[channel].get(i));
  return levels;
}

}  // namespace

TEST_CASE("a line of a power of two is exact", "[gouraud]") {
  const line wanted{4, {0, 255, 100}, {255, 0, 100}};
  CHECK(drawn("q8", wanted, 0) == std::vector<int>{0, 64, 128, 191, 255});  // 63.75, 127.5, 191.25
  CHECK(drawn("q8", wanted, 1) == std::vector<int>{255, 191, 128, 64, 0});
  CHECK(drawn("q8", wanted, 2) == std::vector<int>{100, 100, 100, 100, 100});
}

TEST_CASE("a line of one pixel has its two ends", "[gouraud]") {
  CHECK(drawn("q12", {1, {7, 0, 0}, {250, 0, 0}}, 0) == std::vector<int>{7, 250});
}

TEST_CASE("a pixel is within its bound of the straight line", "[gouraud]") {
  for (const char* format : {"q8", "q12", "q18"}) {
    const int steps = choose("gouraud", format).fraction();
    for (const int length : {2, 3, 7, 100, 641, 1023}) {
      for (const auto& [left, right] : {std::pair{0, 255}, {255, 0}, {13, 200}, {90, 89}}) {
        const std::vector<int> levels = drawn(format, {length, {left, 0, 0}, {right, 0, 0}}, 0);
        REQUIRE(levels.size() == static_cast<std::size_t>(length) + 1);
        for (int x = 0; x <= length; ++x) {
          const double exact = left + static_cast<double>(x) * (right - left) / length;
          const double bound = 0.5 + std::ldexp(x * std::abs(right - left), -steps - 1);
          CAPTURE(format, length, left, right, x);
          // The quotient in double is off by less than 2^-44.
          CHECK(std::abs(levels[static_cast<std::size_t>(x)] - exact) <= bound + std::ldexp(1, -44));
        }
      }
    }
  }
}

TEST_CASE("the right end of the longest line is within a level from q18 on", "[gouraud]") {
  for (const char* format : {"q18", "q20", "q24"}) {
    for (int length = 1; length <= 1023; ++length) {
      const std::vector<int> levels = drawn(format, {length, {0, 255, 17}, {255, 0, 19}}, 0);
      REQUIRE(std::abs(levels.back() - 255) <= 1);
    }
  }
}

TEST_CASE("a line takes its pixels, its steps and a cycle", "[gouraud]") {
  const selection asked = choose("gouraud", "q8");
  const auto device = harness::make_systemc(asked);
  columns out;
  const line wanted{100, {0, 1, 2}, {200, 100, 0}};
  device->run(rows_of(asked, {wanted}), out);
  REQUIRE(out.size() == 101);
  const std::uint64_t before = device->cycles();
  device->run(rows_of(asked, std::vector<line>(50, wanted)), out);
  REQUIRE(out.size() == 50 * 101);
  // One cycle until the first row is offered, one more to take each.
  CHECK(device->cycles() - before == 50 * (101 + 8 + 1) + 1);
}
