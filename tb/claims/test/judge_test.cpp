// SPDX-License-Identifier: Apache-2.0
// The rule that turns figures into verdicts.
#include "tb/claims/judge.h"

#include "tb/catch.h"

namespace blysk::claims {
namespace {

demand stated(std::string figure, relation how, std::string value, std::string reading = "",
              bool law = false) {
  demand result;
  result.name = figure;
  result.figure = std::move(figure);
  result.how = how;
  result.value = std::move(value);
  result.reading = std::move(reading);
  result.law = law;
  return result;
}

std::string verdict(std::vector<demand> demands, const std::map<std::string, std::string>& printed) {
  claim c;
  c.stated = std::move(demands);
  c.open = "no figure is stated";
  const judgement j = judge(c, printed);
  return std::string(j.verdict) + " | " + j.detail + " | " + j.miss;
}

}  // namespace

TEST_CASE("the unit of a figure is that of its last digit", "[claims]") {
  CHECK(unit_of("3.2") == Approx(0.1).epsilon(1e-15));
  CHECK(unit_of("10") == 1);
  CHECK(unit_of("0.00008") == Approx(1e-5).epsilon(1e-15));
  CHECK(unit_of("3.05e-05") == Approx(1e-7).epsilon(1e-15));
  CHECK(unit_of("1.5e+02") == Approx(10).epsilon(1e-15));
  CHECK_THROWS_AS(number_of("3,2"), std::runtime_error);
  CHECK_THROWS_AS(number_of(""), std::runtime_error);
}

TEST_CASE("a figure is met within half a unit", "[claims]") {
  const auto d = stated("x", relation::is, "0.4427");
  CHECK(met(d, "0.4427"));
  CHECK(met(d, "0.44265"));
  CHECK(met(d, "0.44275"));
  CHECK_FALSE(met(d, "0.44264"));
  CHECK_FALSE(met(d, "0.44276"));
  CHECK(miss_of(d, "0.4437") == Approx(10).epsilon(1e-9));
}

TEST_CASE("the good side of a limit has no miss", "[claims]") {
  CHECK(miss_of(stated("x", relation::at_most, "3.2"), "1") == 0);
  CHECK(miss_of(stated("x", relation::at_most, "3.2"), "10.3") == Approx(71).epsilon(1e-9));
  CHECK(met(stated("x", relation::at_most, "3"), "3.5"));
  CHECK_FALSE(met(stated("x", relation::at_most, "3"), "3.51"));
  CHECK(miss_of(stated("x", relation::at_least, "10"), "12") == 0);
  CHECK(miss_of(stated("x", relation::at_least, "10"), "3.2") == Approx(6.8).epsilon(1e-9));
}

TEST_CASE("a law has no printed digits", "[claims]") {
  CHECK(met(stated("x", relation::at_most, "1", "", true), "1"));
  CHECK_FALSE(met(stated("x", relation::at_most, "1", "", true), "1.0001"));
  CHECK_FALSE(met(stated("x", relation::is, "0", "", true), "1e-14"));
}

TEST_CASE("a verdict counts the figures that are met", "[claims]") {
  const auto one = stated("a", relation::is, "1");
  const auto two = stated("b", relation::is, "2");
  CHECK(verdict({one, two}, {{"a", "1"}, {"b", "2.4"}}) == "holds |  | 0.4 (2.4 for 2)");
  CHECK(verdict({one, two}, {{"a", "1.1"}, {"b", "5"}}) == "holds in part | 1 of 2 (a) | 3 (5 for 2)");
  CHECK(verdict({one, two}, {{"a", "9"}, {"b", "5"}}) == "does not hold |  | 8 (9 for 1)");
  CHECK(verdict({}, {}) == "cannot be judged | no figure is stated | -");
}

TEST_CASE("readings are judged each, and one that holds is named", "[claims]") {
  const auto first = stated("a", relation::is, "1", "first");
  const auto second = stated("b", relation::is, "1", "second");
  CHECK(verdict({first, second}, {{"a", "1"}, {"b", "1"}}) == "holds |  | 0");
  CHECK(verdict({first, second}, {{"a", "1"}, {"b", "300"}}) ==
        "depends on the reading | holds for first | 299 (300 for 1)");
  CHECK(verdict({first, second}, {{"a", "2"}, {"b", "3"}}) == "does not hold |  | 2 (3 for 1)");
  const auto third = stated("c", relation::is, "1", "second");
  CHECK(verdict({first, second, third}, {{"a", "3"}, {"b", "1"}, {"c", "2"}}) ==
        "holds in part | 1 of 2 for second (b) | 2 (3 for 1)");
}

TEST_CASE("many figures are counted by one", "[claims]") {
  demand d;
  d.figure = "met";
  d.of = 45;
  d.largest_miss = "miss";
  CHECK(verdict({d}, {{"met", "45"}, {"miss", "0.5"}}) == "holds |  | 0.5");
  CHECK(verdict({d}, {{"met", "17"}, {"miss", "4.6"}}) == "holds in part | 17 of 45 | 4.6");
  CHECK(verdict({d}, {{"met", "0"}, {"miss", "4.6"}}) == "does not hold |  | 4.6");
}

TEST_CASE("a law's miss comes before those that are met", "[claims]") {
  const auto law = stated("a", relation::at_most, "1", "", true);
  const auto limit = stated("b", relation::at_most, "10");
  CHECK(verdict({law, limit}, {{"a", "1.02"}, {"b", "10.4"}}) == "holds in part | 1 of 2 (b) | 1.02 for 1");
}

}  // namespace blysk::claims
