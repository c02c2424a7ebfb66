// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>
#include <vector>

#include "tb/catch.h"
#include "tb/golden/angle.h"
#include "tb/golden/lobe.h"

using namespace blysk::golden;

TEMPLATE_TEST_CASE("a picture's values are those of single points, bit for bit", "[golden]", float, double) {
  for (const auto& [which, name] : kLobes) {
    for (const TestType n : {TestType(1), TestType(2), TestType(7), TestType(1000)}) {
      // 131 elements from an odd start: whole vectors of every width, and what is left over.
      std::vector<TestType> cosines(132);
      for (std::size_t i = 0; i < cosines.size(); ++i) cosines[i] = static_cast<TestType>(i) / TestType(131);
      std::vector<TestType> out(131, TestType(-1));
      evaluate(which, n, std::span<const TestType>(cosines).subspan(1), std::span<TestType>(out));
      for (std::size_t i = 0; i < out.size(); ++i) {
        CAPTURE(name, n, cosines[i + 1]);
        REQUIRE(out[i] == evaluate(which, n, cosines[i + 1]));
      }
    }
  }
}

TEMPLATE_TEST_CASE("a picture of the angle-based lobe is that of single points, bit for bit", "[golden]",
                   float, double) {
  std::vector<TestType> angles(158);
  for (std::size_t i = 0; i < angles.size(); ++i) angles[i] = static_cast<TestType>(i) / 100;
  std::vector<TestType> out(angles.size(), TestType(-1));
  const TestType n = 50;
  const TestType q = TestType(0.3);
  for (const int k : {1, 5}) {
    angle_lobe(n, TestType(k), q, std::span<const TestType>(angles), std::span<TestType>(out));
    for (std::size_t i = 0; i < out.size(); ++i) {
      CAPTURE(k, angles[i]);
      REQUIRE(out[i] == angle_lobe(n, TestType(k), q, angles[i]));
    }
  }
}

TEST_CASE("a picture is refused for a bad exponent or unequal lengths", "[golden]") {
  std::vector<double> out(3);
  const std::vector<double> cosines{0, 0.5, 1};
  CHECK_THROWS_AS(evaluate(lobe::gx, 0.5, std::span(cosines), std::span(out)), std::domain_error);
  CHECK_THROWS_AS(evaluate(lobe::gx, 5.0, std::span(cosines).first(2), std::span(out)), std::domain_error);
  CHECK_THROWS_AS(angle_lobe(5.0, 0.5, 0.5, std::span(cosines), std::span(out)), std::domain_error);
  CHECK_THROWS_AS(angle_lobe(5.0, 2.0, 1.0, std::span(cosines), std::span(out)), std::domain_error);
}
