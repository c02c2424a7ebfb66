// SPDX-License-Identifier: Apache-2.0
// Every golden model against values that were worked by another way, in another language: values.py says how.
#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <vector>

#include "tb/catch.h"
#include "tb/golden/angle.h"
#include "tb/golden/registry.h"

using namespace blysk::golden;

namespace {

struct known_value {
  std::string_view model;
  std::vector<double> inputs;
  double value;
  double tolerance;  ///< largest relative error: roundoffs times condition number, or that of a quadrature
};

const std::vector<known_value>& known_values() {
  static const std::vector<known_value> values{
#include "tb/golden/test/values.inc"
  };
  return values;
}

}  // namespace

TEST_CASE("every model gives the values that were worked by another way", "[golden][values]") {
  for (const known_value& known : known_values()) {
    const model* const m = find_model(known.model);
    INFO(known.model << " at " << Catch::Detail::stringify(known.inputs));
    REQUIRE(m != nullptr);
    const double found = m->value(known.inputs);
    // The value stands there as a double itself, half an ulp off.
    const double allowed =
        (known.tolerance + 0x1p-53) * std::abs(known.value) + std::numeric_limits<double>::denorm_min();
    INFO("got " << found << ", expected " << known.value << ", off by " << (found - known.value) / known.value
                << ", allowed " << known.tolerance << ", relatively");
    CHECK(std::abs(found - known.value) <= allowed);
  }
}

TEST_CASE("no model is without such values, and none of the lobes at n = 2, 7, 100 and 1000",
          "[golden][values]") {
  std::set<std::pair<std::string_view, double>> first_inputs;
  std::set<std::string_view> names;
  for (const known_value& known : known_values()) {
    names.insert(known.model);
    first_inputs.emplace(known.model, known.inputs.front());
  }
  for (const model& m : models()) {
    CAPTURE(m.name);
    CHECK(names.contains(m.name));
    if (!m.header.starts_with("n,")) continue;
    for (const double n : {2.0, 7.0, 100.0, 1000.0}) {
      if (m.header.ends_with("incidence") && m.header.starts_with("n,k,")) continue;
      CAPTURE(n);
      CHECK(first_inputs.contains({m.name, n}));
    }
  }
}

TEST_CASE("the angle of a level is that of its cosine where that is a known one", "[golden][values]") {
  // acos(q^(1/n)): the models have quotients of such angles, in which a common factor cancels.
  struct known_angle {
    double n, q, in_pi;
  };
  for (const auto& [n, q, in_pi] :
       {known_angle{1, 0.5, 1.0 / 3}, known_angle{2, 0.75, 1.0 / 6}, known_angle{2, 0.25, 1.0 / 3},
        known_angle{8, 0.0625, 1.0 / 4}, known_angle{100, 0x1p-50, 1.0 / 4},
        known_angle{1000, 0x1p-500, 1.0 / 4}}) {
    CAPTURE(n, q);
    const double angle = in_pi * 3.14159265358979323846;
    CHECK(std::abs(angle_of_level(n, q) - angle) <= 16 * 0x1p-53 * angle);
  }
}
