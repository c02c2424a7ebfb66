// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>
#include <vector>

#include "tb/catch.h"
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

TEST_CASE("a picture is refused for a bad exponent or unequal lengths", "[golden]") {
  std::vector<double> out(3);
  const std::vector<double> cosines{0, 0.5, 1};
  CHECK_THROWS_AS(evaluate(lobe::gx, 0.5, std::span(cosines), std::span(out)), std::domain_error);
  CHECK_THROWS_AS(evaluate(lobe::gx, 5.0, std::span(cosines).first(2), std::span(out)), std::domain_error);
}
