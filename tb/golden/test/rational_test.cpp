// SPDX-License-Identifier: Apache-2.0
// The rational lobe against the best of its form, which an exchange finds anew: (1 - r y)/(1 - r y + s y), zero beyond
// its root, against e^-y.
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>

#include "tb/catch.h"
#include "tb/golden/errors.h"

using namespace blysk::golden;

namespace {

struct form {
  double r, s;

  double error(double y) const {
    const double numerator = 1 - r * y;
    return (numerator > 0 ? numerator / (numerator + s * y) : 0) - std::exp(-y);
  }
  double root() const { return 1 / r; }
};

/// The form that takes the value v at y and w at z: r y (1 - v) + s y v = 1 - v, and so for z and w.
form through(double y, double v, double z, double w) {
  const double determinant = y * (1 - v) * z * w - y * v * z * (1 - w);
  return {((1 - v) * z * w - y * v * (1 - w)) / determinant,
          (y * (1 - v) * (1 - w) - (1 - v) * z * (1 - w)) / determinant};
}

/// Where sign * error is largest between low and high.
double extreme(const form& f, double sign, double low, double high) {
  return boost::math::tools::brent_find_minima([&](double y) { return -sign * f.error(y); }, low, high,
                                               std::numeric_limits<double>::digits / 2)
      .first;
}

struct best {
  form f;
  double first, second, error;
};

/// Exchange: the form whose errors at two points and at its own root are -E, +E, -E; then the points move to the
/// extremes of that form, until they stay.
best exchange() {
  best b{{}, 0.3, 1.8, 0};
  for (int round = 0; round < 40; ++round) {
    const auto with = [&](double e) {
      return through(b.first, std::exp(-b.first) - e, b.second, std::exp(-b.second) + e);
    };
    const auto [low, high] =
        boost::math::tools::bisect([&](double e) { return std::exp(-with(e).root()) - e; }, 0.0, 0.03,
                                   boost::math::tools::eps_tolerance<double>());
    b.error = (low + high) / 2;
    b.f = with(b.error);
    b.first = extreme(b.f, -1, 0, (b.first + b.second) / 2);
    b.second = extreme(b.f, 1, (b.first + b.second) / 2, b.f.root());
  }
  return b;
}

/// Where the error vanishes between two points of opposite sign.
double zero_between(const form& f, double low, double high) {
  const auto [a, b] = boost::math::tools::bisect([&](double y) { return f.error(y); }, low, high,
                                                 boost::math::tools::eps_tolerance<double>());
  return (a + b) / 2;
}

}  // namespace

TEST_CASE("the rational lobe is the best of its form: its errors alternate", "[golden][rational]") {
  const best b = exchange();
  // Brent's method places an extreme to 2^-26, where the error is flat; the exchange's own equations hold to roundings.
  CHECK(std::abs(b.f.error(b.first) + b.error) < 1e-14);
  CHECK(std::abs(b.f.error(b.second) - b.error) < 1e-14);
  CHECK(std::abs(b.f.error(b.f.root()) + b.error) < 1e-14);
  // What docs/numerics.md states.
  CHECK(std::abs(b.error - 0.0247982) < 5e-8);
  CHECK(std::abs(b.f.r - 0.270491) < 5e-7);
  CHECK(std::abs(b.f.s - 1.214663) < 5e-7);
  // The levels of the model are those at which that error vanishes, to 6 digits.
  CHECK(std::abs(std::exp(-zero_between(b.f, b.first, b.second)) - 0.425856) < 5e-7);
  CHECK(std::abs(std::exp(-zero_between(b.f, b.second, b.f.root())) - 0.050698) < 5e-7);

  // The model itself, at an exponent where c^n is e^-y to 1/n, alternates; a digit more or less in a level moves an
  // extreme by 1e-6 or so.
  constexpr double kLarge = 1e9;
  const rational_lobe<double> model(kLarge);
  const form limit{model.r / kLarge, model.s / kLarge};
  const double tolerance = 1e-6;
  CHECK(std::abs(limit.error(extreme(limit, -1, 0, 1)) + b.error) < tolerance);
  CHECK(std::abs(limit.error(extreme(limit, 1, 1, 3)) - b.error) < tolerance);
  CHECK(std::abs(limit.error(limit.root()) + b.error) < tolerance);
}

TEST_CASE("no rational lobe of a grid is better", "[golden][rational]") {
  const best b = exchange();
  for (int i = -20; i <= 20; ++i) {
    for (int j = -20; j <= 20; ++j) {
      const form other{b.f.r * (1 + i / 100.0), b.f.s * (1 + j / 100.0)};
      double largest = 0;
      for (double y = 0; y < 6; y += 1.0 / 128) largest = std::max(largest, std::abs(other.error(y)));
      largest = std::max(largest, std::abs(other.error(other.root())));
      CAPTURE(i, j);
      // An extreme between two samples is missed by its curvature, at most 4, times their distance squared over 8.
      REQUIRE(largest >= b.error - 4.0 / 128 / 128 / 8);
    }
  }
}

TEST_CASE("the rational lobe's error for each exponent", "[golden][rational]") {
  double most = 0;
  for (int n = 1; n <= 1000; ++n)
    most = std::max(most, largest_absolute_error(clamped_lobe(lobe::rational, n), n, 0).value);
  CHECK(most < 0.0248);   // as docs/numerics.md states
  CHECK(most > 0.02475);  // and nearly reached, at n = 1000
  CHECK(largest_absolute_error(clamped_lobe(lobe::rational, 1), 1, 0).value < 1e-14);
}
