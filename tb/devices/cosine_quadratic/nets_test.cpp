// SPDX-License-Identifier: Apache-2.0
// Every net of [T] fig. 3.1 by its formula, written out a second time. One process per case: SystemC elaborates once.
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>

#include "tb/catch.h"
#include "tb/specular/test/bench.h"

namespace {

using namespace blysk;
using namespace blysk::specular;

/// x / 2^bits rounded to nearest, ties up.
std::int64_t rounded(std::int64_t x, int bits) {
  return bits == 0 ? x : (x + (std::int64_t{1} << (bits - 1))) >> bits;
}

/// x 2^bits rounded to nearest; double has digits enough for the words of q12.
std::int64_t word(double x, int bits) {
  return static_cast<std::int64_t>(std::floor(std::ldexp(x, bits) + 0.5));
}

/// \param format  up to q12: the formulas here have no more than 64 bits
void check_nets(const std::string& format, const std::map<std::string, std::string>& options) {
  const selection asked = choose("cosine-quadratic", format, options);
  const word_lengths widths = asked.of().widths(asked);
  const int f = widths.at("cos");
  const int t = widths.at("line");
  const bool by_limit = asked.value("gating") == "published";
  const bool of_lsb = asked.value("constants") == "published";
  const std::string& energy = asked.value("energy");
  const bool is_limited = !by_limit && !of_lsb;
  const int s = energy == "none" ? f : widths.at("square");
  specular::test::bench pins(asked);
  pins.reset();
  std::mt19937_64 random(1);
  int inside = 0;
  int beyond = 0;
  for (int i = 0; i < 3000; ++i) {
    specular::test::codes data{};
    for (std::size_t column = 0; column < data.size(); ++column) {
      const wire_format& of = pins.format(column);
      data.at(column) =
          of.min + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(of.max - of.min + 1));
    }
    if (i % 2 == 0) {  // one half within the lobe, or near it
      const std::int64_t reach = (std::int64_t{4} << f) / (data[kN] + 1) + 1;
      data[kCos] = (std::int64_t{1} << f) - data[kCos] % std::min(reach, std::int64_t{1} << f);
    }
    pins.load(data);
    const auto n = static_cast<double>(data[kN]);
    const std::int64_t c = data[kCos];
    const std::int64_t slope = word((n + 1) / 3, f);
    const std::int64_t cos_minus_1 = c - (of_lsb ? 1 : std::int64_t{1} << f);
    const std::int64_t product = slope * cos_minus_1;
    const std::int64_t line = product + (of_lsb ? 1 : std::int64_t{1} << (2 * f));
    std::int64_t line_rounded = rounded(line, 2 * f - t);
    if (is_limited) line_rounded = std::max(line_rounded, -(std::int64_t{1} << t));
    const std::int64_t square = rounded(line_rounded * line_rounded, 2 * t - s);
    const std::int64_t limit = n <= 2 ? 0 : word(std::pow((n - 2) / (n + 1), n), f);
    const bool is_off = by_limit ? square < limit : line < 0;
    const std::int64_t lobe = is_off ? 0 : square;
    std::int64_t brdf = lobe;
    CAPTURE(n, c);
    REQUIRE(pins.held() == data);
    REQUIRE(pins.net("minus_one") == -1);
    REQUIRE(pins.net("grounded") == 0);
    REQUIRE(pins.net("carry29_in") == 1);
    REQUIRE(pins.net("slope") == slope);
    REQUIRE(pins.net("cos_minus_1") == cos_minus_1);
    REQUIRE(pins.net("product") == product);
    REQUIRE(pins.net("line") == line);
    REQUIRE(pins.net("line_rounded") == line_rounded);
    REQUIRE(pins.net("square") == square);
    REQUIRE(pins.net("beyond_root") == (is_off ? 1 : 0));
    if (by_limit) REQUIRE(pins.net("limit") == limit);
    if (energy != "none") {
      const int e = widths.at("factor");
      const std::int64_t factor =
          energy == "published" ? word((n + 6) / 24.55, e)
                                : static_cast<std::int64_t>(std::floor(std::ldexp((n + 1) / (8 * M_PI), e)));
      REQUIRE(pins.net("factor") == factor);
      REQUIRE(pins.net("lobe") == lobe);
      brdf = rounded(lobe * factor, s + e - f);
    }
    REQUIRE(pins.actual() ==
            std::vector<std::int64_t>{brdf, brdf * data[kRed], brdf * data[kGreen], brdf * data[kBlue]});
    (lobe > 0 ? inside : beyond) += 1;
  }
  CHECK(inside > 300);
  CHECK((beyond > 300 || !is_limited));
}

}  // namespace

TEST_CASE("every net of fig. 3.1 holds its formula", "[netlist]") {
  check_nets("q8", {});
}
TEST_CASE("every net of fig. 3.1 holds its formula, q12", "[netlist]") {
  check_nets("q12", {});
}
TEST_CASE("every net of fig. 3.1 holds its formula, gated by comparator 11", "[netlist]") {
  check_nets("q8", {{"gating", "published"}});
}
TEST_CASE("every net of fig. 3.1 holds its formula, constants of an LSB", "[netlist]") {
  check_nets("q8", {{"constants", "published"}});
}
TEST_CASE("every net of fig. 3.1 holds its formula, all as published", "[netlist]") {
  check_nets("q12", {{"gating", "published"}, {"constants", "published"}});
}
TEST_CASE("every net of fig. 3.1 holds its formula, published energy factor", "[netlist]") {
  check_nets("q8", {{"energy", "published"}});
}
TEST_CASE("every net of fig. 3.1 holds its formula, safe energy factor", "[netlist]") {
  check_nets("q12", {{"energy", "safe"}});
}
