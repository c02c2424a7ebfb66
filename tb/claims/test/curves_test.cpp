// SPDX-License-Identifier: Apache-2.0
// Points of the curves: closed forms, and 50 digits where double precision would hide a difference.
#include <fmt/format.h>

#include "tb/catch.h"
#include "tb/claims/test/fifty_digits.h"
#include "tb/claims/test/literal.h"
#include "tb/claims/test/second.h"

namespace blysk::claims {
namespace {

using namespace literal;
/// [P] (9) as printed.
real exact_a_50(int n) {
  if (n == 1) return 0;
  const real t = sqrt(real(n - 1) / n);
  return (pow(t, n - 1) - 1) / (t - 1);
}

/// Angle at which cos^n bends the other way: the second difference of step 1e-12, which errs by 1e-24, changes its sign.
real inflection(int n) {
  const real step("1e-12");
  const auto bend = [&](const real& x) {
    return real(pow(cos(real(x - step)), n) - 2 * pow(cos(x), n) + pow(cos(real(x + step)), n));
  };
  real low = real(1) / 1000;
  real high = real(3) / 2;
  REQUIRE(bend(low) < 0);
  REQUIRE(bend(high) > 0);
  for (int i = 0; i < 80; ++i) {
    const real middle = (low + high) / 2;
    (bend(middle) < 0 ? low : high) = middle;
  }
  return low;
}

}  // namespace

TEST_CASE("points of the curves have closed forms", "[claims]") {
  std::map<std::string, figures> rows;
  const auto quadratic = [](int n, const real& c) {
    const real a = exact_a_50(n);
    return real(a * c * c + (1 - a) * c);  // (3) to (6)
  };
  rows["P1"]["gap"] = std::max(largest_gap(1, [&](int n) { return real(quadratic(n, 1) - 1); }),
                               largest_gap(1, [&](int n) { return quadratic(n, 0); }));
  rows["P3"]["gap"] = largest_gap(2, [&](int n) {
    const real t = sqrt(real(n - 1) / n);
    return real((quadratic(n, t) - pow(t, n)) / n);
  });
  real factor = 0;
  for (const int n : {2, 3, 10, 100, 1000}) {
    const real gamma = inflection(n);
    factor = std::max(factor, real(abs(real((n - 1) * pow(sin(gamma), 2) - pow(cos(gamma), 2)))));
  }
  rows["P2"]["factor"] = as_double(factor);

  const real slope = 2 * (1 - exp(real(-1) / 2));
  rows["P4"] = {{"slope", as_double(slope)}, {"offset", as_double(real(exact_a_50(1000) - 1000 * slope))}};
  const real printed_slope = real(786) / 1000;
  for (const auto& [key, s, offset] : {std::tuple{"printed", printed_slope, real(0.5)},
                                       {"turned", printed_slope, real(-0.5)},
                                       {"derived", slope, real(-0.5)}}) {
    const peak p = over_n(1, 1000, [&s = s, &offset = offset](int n) {
      return as_double(real(abs(real(s * n + offset - exact_a_50(n)))));
    });
    rows["P4"][key] = p.value;
    rows["P4"][fmt::format("{}_n", key)] = static_cast<double>(p.n);
  }

  // Schlick's lobe of n = 1000 rises least in its first step, from 0 to (1/256) / (1000 - 999/256).
  rows["T3"]["step"] = -1.0 / (256 * 1000 - 999);
  // The integral of s^2 c^2 + 2 s (1 - s) c + (1 - s)^2 from its root to 1, term by term; at n = 1 from 0.
  const auto area = [](int n) {
    const real s = real(n + 1) / 3;
    const real low = n == 1 ? real(0) : real(1 - 1 / s);
    return real(s * s * (1 - pow(low, 3)) / 3 + s * (1 - s) * (1 - pow(low, 2)) +
                (1 - s) * (1 - s) * (1 - low));
  };
  rows["T14"] = {{"gap", largest_gap(2, [&](int n) { return real((area(n) * (n + 1) - 1) / n); })},
                 {"n1", as_double(area(1))}};
  const double place = largest_gap(
      1, [](int n) { return real(cos(atan(real(sqrt(real(1 + 2 * n)) / n))) - real(n) / (n + 1)); });
  const auto level = [](double n) { return std::exp(-n * std::log1p(1 / n)); };
  rows["T15"] = {{"place", place},
                 {"level_1", 0.5},
                 {"level_1000", level(1000)},
                 {"error_2", 100 * (4.0 / 9 * 9 / 4 - 1)},
                 {"error_1000", 100 * (4.0 / 9 / level(1000) - 1)},
                 {"from", 6.0}};
  CHECK(level(5) > 0.4);
  CHECK(level(6) < 0.4);
  // The half angle's formula against the printed term, at cos(theta) = 1.
  rows["T32"] = {{"printed", 1.0 / 2}, {"meant", std::sqrt((1 + 1.0) / 2)}};

  // cos^2 of 15, 30 and 45 degrees, to the fifth.
  const real at_15 = pow(real((2 + sqrt(real(3))) / 4), 5);
  const real at_30 = pow(real(real(3) / 4), 5);
  rows["T52"] = {{"a0", 1.0},
                 {"a15", as_double(at_15)},
                 {"a30", as_double(at_30)},
                 {"a45", 1.0 / 32},
                 {"ratio", as_double(real(at_30 / at_15))}};

  const auto lowest = [](double a) { return -(a - 1) * (a - 1) / (4 * a); };
  const double a = derived_a(1000);
  rows["E4"] = {{"published", lowest(published_a(1000))}, {"derived", lowest(a)}, {"cos", (a - 1) / (2 * a)}};
  rows["E5"]["square"] = 998.0 * 998 / 9;
  rows["E12"] = {{"level_060_2", 0.6},  {"level_060_1000", 0.6},
                 {"level_056_2", 0.56}, {"level_056_1000", 0.56},
                 {"level_infl_2", 0.5}, {"level_infl_1000", std::exp(500 * std::log1p(-0.001))}};
  check_rows("points of the curves have closed forms", rows);
}

}  // namespace blysk::claims
