// SPDX-License-Identifier: Apache-2.0
// Every net of [P] fig. 1 by its formula, written out a second time. One process per case: SystemC elaborates once.
#include <algorithm>
#include <map>
#include <random>
#include <string>

#include "tb/catch.h"
#include "tb/devices/quadratic/wires.h"
#include "tb/specular/test/bench.h"

namespace {

using namespace blysk;
using namespace blysk::specular;

/// x / 2^bits rounded to nearest, ties up.
std::int64_t rounded(std::int64_t x, int bits) {
  return bits == 0 ? x : (x + (std::int64_t{1} << (bits - 1))) >> bits;
}

/// \param format  up to q16: the formulas here have no more than 64 bits
void check_nets(const std::string& format, const std::map<std::string, std::string>& options) {
  const selection asked = choose("quadratic", format, options);
  const wired_constants wired = quadratic_device::wires(asked);
  const word_lengths widths = asked.of().widths(asked);
  const int f = widths.at("cos");
  const int k = widths.at("coefficient");
  const int d = widths.at("square");
  specular::test::bench pins(asked);
  pins.reset();
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    specular::test::codes data{};
    for (std::size_t column = 0; column < data.size(); ++column) {
      const wire_format& of = pins.format(column);
      data.at(column) =
          of.min + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(of.max - of.min + 1));
    }
    pins.load(data);
    const std::int64_t n = data[kN];
    const std::int64_t c = data[kCos];
    const std::int64_t a = wired.slope * n + wired.offset * (std::int64_t{1} << (k - 1));
    const std::int64_t cos2 = rounded(c * c, 2 * f - d);
    const std::int64_t moved = c * (std::int64_t{1} << (d - f));
    const std::int64_t diff = cos2 - moved;
    const std::int64_t parabola = a * diff + moved * (std::int64_t{1} << k);
    std::int64_t brdf = rounded(parabola, k + d - f);
    if (!asked.flag("as-published")) brdf = std::clamp(brdf, std::int64_t{0}, std::int64_t{1} << f);
    CAPTURE(n, c);
    REQUIRE(pins.held() == data);
    REQUIRE(pins.net("slope") == wired.slope);
    REQUIRE(pins.net("offset") == wired.offset);
    REQUIRE(pins.net("carry28_in") == 1);
    REQUIRE(pins.net("carry30_in") == 0);
    REQUIRE(pins.net("slope_n") == wired.slope * n);
    REQUIRE(pins.net("a") == a);
    REQUIRE(pins.net("cos2") == cos2);
    REQUIRE(pins.net("cos_inv") == -moved - 1);
    REQUIRE(pins.net("cos2_minus_cos") == diff);
    REQUIRE(pins.net("a_times_diff") == a * diff);
    REQUIRE(pins.net("parabola") == parabola);
    REQUIRE(pins.actual() ==
            std::vector<std::int64_t>{brdf, brdf * data[kRed], brdf * data[kGreen], brdf * data[kBlue]});
  }
}

}  // namespace

TEST_CASE("every net of fig. 1 holds its formula", "[netlist]") {
  check_nets("q8", {});
}
TEST_CASE("every net holds its formula where the square is rounded", "[netlist]") {
  check_nets("q16", {});
}
TEST_CASE("every net holds its formula, coefficient and lobe published", "[netlist]") {
  check_nets("q8", {{"coefficient", "published"}, {"as-published", "on"}});
}
TEST_CASE("every net holds its formula, another constant wired", "[netlist]") {
  check_nets("q12", {{"constant", "110010"}});
}
