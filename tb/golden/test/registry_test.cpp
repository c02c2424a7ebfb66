// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/registry.h"

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
  for (const auto name : {"blinn", "schlick", "schlick-modified", "schlick-modified-a", "schlick-modified-b",
                          "schlick-modified-c", "quadratic-exact", "quadratic-published", "quadratic-derived",
                          "cosine-quadratic", "cosine-quadratic-energy", "blinn-normalised", "angle",
                          "angle-coef-exact", "angle-coef-fitted", "lyon-2", "lyon-4", "lyon-8", "gx"})
    CHECK(names.contains(name));
  for (const auto& row : kLobes) CHECK(names.contains(row.name));
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
}
