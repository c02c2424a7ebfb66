// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/registry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tb/catch.h"
#include "tb/golden/lobe.h"

using namespace blysk::golden;

namespace {

double call(std::string_view name, std::vector<double> inputs) {
  return find_model(name)->value(inputs);
}

std::string refusal(std::string_view name, std::vector<double> inputs) {
  try {
    find_model(name)->value(inputs);
  } catch (const std::domain_error& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("every promised name is served, once", "[golden]") {
  std::set<std::string_view> names;
  for (const model& m : models()) CHECK(names.insert(m.name).second);
  for (const auto name : {"blinn",
                          "schlick",
                          "schlick-modified",
                          "schlick-modified-a",
                          "schlick-modified-b",
                          "schlick-modified-c",
                          "quadratic-exact",
                          "quadratic-published",
                          "quadratic-derived",
                          "cosine-quadratic",
                          "cosine-quadratic-energy",
                          "blinn-normalised",
                          "angle",
                          "angle-coef-exact",
                          "angle-coef-fitted",
                          "angle-coef-safe",
                          "lyon-2",
                          "lyon-4",
                          "lyon-8",
                          "gx",
                          "schlick-modified-e",
                          "coefficient-exact",
                          "coefficient-published",
                          "coefficient-derived",
                          "angle-limit",
                          "lambert",
                          "phong",
                          "blinn-shading",
                          "fresnel",
                          "facets-gaussian",
                          "facets-beckmann",
                          "shadowing",
                          "cook-torrance-gaussian",
                          "cook-torrance-beckmann",
                          "reciprocal-shifts",
                          "shift-division",
                          "angle-reflectance"})
    CHECK(names.contains(name));
  for (const auto& row : kLobes) {
    CHECK(names.contains(row.name));
    CHECK(names.contains(std::string(row.name) + "-reflectance"));
    CHECK(names.contains(std::string(row.name) + "-reflectance-mirror"));
  }
  CHECK(find_model("ward") == nullptr);
}

TEST_CASE("values worked out by hand", "[golden]") {
  CHECK(call("blinn", {2, 0.5}) == 0.25);
  CHECK(call("schlick", {3, 0.5}) == 0.25);                // 0.5 / (1.5 + 0.5)
  CHECK(call("schlick-modified", {4, 0.5}) == 0.5 / 4.5);  // 2 + 2 + 0.5
  CHECK(call("schlick-modified-a", {4, 0.5}) == 0.5 / 4);  // 1.5 + 2 + 0.5
  CHECK(call("schlick-modified-b", {4, 0.5}) == 0.5 / 3);  // 0.5 + 2 + 0.5
  CHECK(call("quadratic-exact", {1, 0.5}) == 0.5);         // a(1) = 0
  CHECK(call("quadratic-published", {1000, 0}) == 0);
  CHECK(!std::signbit(call("quadratic-published", {1000, 0})));
  CHECK(call("cosine-quadratic", {2, 0.5}) == 0.25);  // (1 - 0.5)^2
  CHECK(call("cosine-quadratic", {11, 0.5}) == 0);    // beyond the root 0.75
  CHECK(call("lyon-2", {2, 0.5}) == 0.25);
  CHECK(call("lyon-8", {8, 0.5}) == 1.0 / 256);
  CHECK(call("gx", {2, 0.5}) == 0.25);  // c^2 / 1
  CHECK(call("rational", {1, 0.25}) ==
        Approx(0.25).epsilon(0).margin(1e-14));  // c itself at n = 1, 60 roundoffs
  CHECK(call("angle", {10, 2, 0.5, 0}) == 1);
  // The same parabola by its line: 786.5 (0.25 - 0.5) + 0.5, its slope rounded by 4 roundoffs.
  CHECK(quadratic(coefficient_line::published, 1000.0, 0.5) == Approx(-196.125).epsilon(1e-15));
  CHECK(rational(1.0, 0.25) == call("rational", {1, 0.25}));
}

TEST_CASE("a model takes as many inputs as its header has columns", "[golden]") {
  for (const model& m : models()) {
    CAPTURE(m.name);
    const auto columns = static_cast<std::size_t>(std::ranges::count(m.header, ',')) + 1;
    // 1 is inside the range of every first column, so that what is refused is the number of columns alone.
    for (const std::size_t count : {columns - 1, columns + 1}) {
      const std::string expected =
          "number of inputs is " + std::to_string(count) + ", expected " + std::to_string(columns);
      CHECK(refusal(m.name, std::vector<double>(count, 1)) == expected);
    }
  }
}

TEST_CASE("no model takes a NaN or an infinite number", "[golden]") {
  for (const model& m : models()) {
    const auto columns = static_cast<std::size_t>(std::ranges::count(m.header, ',')) + 1;
    for (std::size_t column = 0; column < columns; ++column) {
      for (const double bad :
           {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        // A point inside every other range: 1 for most, less for levels and cosines, whole for steps.
        std::vector<double> inputs(columns, 1);
        std::string_view names = m.header;
        for (double& input : inputs) {
          const std::string_view name = names.substr(0, names.find(','));
          names.remove_prefix(std::min(names.size(), name.size() + 1));
          if (name == "q" || name == "cos") input = 0.5;
          if (name == "n") input = 10;
          if (name == "index") input = 1.5;
        }
        CAPTURE(m.name, column);
        CHECK(refusal(m.name, inputs) == "accepted");
        inputs[column] = bad;
        CHECK(refusal(m.name, inputs) != "accepted");
      }
    }
  }
}

TEST_CASE("arguments outside their range are refused by name", "[golden]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal("blinn", {0, 0.5}) == "n is 0, expected a number in [1, 1000]");
  CHECK(refusal("gx", {1001, 0.5}) == "n is 1001, expected a number in [1, 1000]");
  CHECK(refusal("gx", {nan, 0.5}) == "n is nan, expected a number in [1, 1000]");
  CHECK(refusal("schlick", {10, 1.5}) == "cos is 1.5, expected a number in [0, 1]");
  CHECK(refusal("schlick", {10, nan}) == "cos is nan, expected a number in [0, 1]");
  CHECK(refusal("schlick", {10}) == "number of inputs is 1, expected 2");
  CHECK(refusal("angle", {10, 0.5, 0.5, 0}) == "k is 0.5, expected a number in [1, 1000]");
  CHECK(refusal("angle", {10, 1, 1, 0}) == "q is 1, expected a number in (0, 1)");
  CHECK(refusal("angle", {10, 1, 0.5, 2}) == "x is 2, expected an angle in [0, pi/2] radians");
  CHECK(refusal("angle-coef-fitted", {10, 1, 0.45}) ==
        "q is 0.45000000000000001, expected a number in [0.1, 0.4] or [0.5, 0.9], where the fit was made");
  CHECK(refusal("angle-coef-fitted", {2, 2, 0.5}) == "n is 2, expected more than k, where the fit was made");
  CHECK(refusal("angle-coef-exact", {2, 2, 0.45}) == "accepted");
  CHECK(refusal("coefficient-exact", {0.5}) == "n is 0.5, expected a number in [1, 1000]");
  CHECK(refusal("schlick-modified-e", {10, -1, 0.5}) == "a is -1, expected a number in [0, 1000]");
  CHECK(refusal("blinn-reflectance", {10, 90}) == "incidence is 90, expected an angle in [0, 90) degrees");
  CHECK(refusal("lambert", {1, 1, 1, -0.5, 0, 0, 1, 0, 0, 1}) ==
        "kd is -0.5, expected a finite number that is not negative");
  CHECK(refusal("lambert", {1, 1, 1, 1, 0, 0, 0, 0, 0, 1}) == "nx is 0, expected a vector that is not zero");
  CHECK(refusal("lambert", {1, 1, 1, 1, 1e-200, 0, 0, 0, 0, 1e200}) == "accepted");
  CHECK(refusal("phong", {0, 1, 1, 1, 1, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}) ==
        "n is 0, expected a number in [1, 1000]");
  CHECK(refusal("facets-beckmann", {0, 0.5}) == "m is 0, expected a number in (0, 1]");
  CHECK(refusal("fresnel", {1, 0.5}) == "index is 1, expected a number in (1, 1000]");
  CHECK(refusal("shadowing", {0.5, 0.5, 0.5, 0}) == "nv is 0, expected a number in (0, 1]");
  CHECK(refusal("reciprocal-shifts", {7.5, 8}) == "k is 7.5, expected a whole number in [1, 2^31]");
  CHECK(refusal("reciprocal-shifts", {7, 32}) == "steps is 32, expected a whole number in [1, 31]");
  CHECK(refusal("reciprocal-shifts", {0, 8}) == "k is 0, expected a whole number in [1, 2^31]");
}
