// SPDX-License-Identifier: Apache-2.0
// Properties over the whole domain, on random points; the seed is fixed by the test's environment.
#include <rapidcheck.h>

#include <cmath>

#include "tb/catch.h"
#include "tb/golden/angle.h"
#include "tb/golden/energy.h"
#include "tb/golden/lobe.h"
#include "tb/golden/running_error.h"
#include "tb/golden/scene.h"

using namespace blysk::golden;

namespace {

/// Evenly spread over [low, high].
rc::Gen<double> in_range(double low, double high) {
  return rc::gen::map(rc::gen::inRange<int64_t>(0, int64_t{1} << 53), [=](int64_t i) {
    return low + (high - low) * std::ldexp(static_cast<double>(i), -53);
  });
}

rc::Gen<double> exponents() {  // as many below 30 as above
  return rc::gen::map(in_range(0, std::log(1000.0)),
                      [](double logarithm) { return std::clamp(std::exp(logarithm), 1.0, 1000.0); });
}

/// Half of them in the lobe, whose width is 1/n.
rc::Gen<double> cosines(double n) {
  return rc::gen::oneOf(in_range(0, 1), rc::gen::map(in_range(0, 1), [n](double x) { return 1 - x / n; }));
}

rc::Gen<vec3<double>> directions() {
  return rc::gen::map(
      rc::gen::pair(in_range(-1, 1), in_range(0, 6.283185307179586)), [](const std::pair<double, double>& p) {
        const double radius = std::sqrt((1 - p.first) * (1 + p.first));
        return vec3<double>{radius * std::cos(p.second), radius * std::sin(p.second), p.first};
      });
}

/// A pair of arguments, the second a few numbers or any distance below the first, neither negative.
template <class Real>
std::pair<Real, Real> pair_below(Real first, Real second) {
  if (*rc::gen::inRange(0, 2) == 0) {
    second = first;
    for (int steps = *rc::gen::inRange(1, 9); steps > 0; --steps) second = std::nextafter(second, Real(-1));
    second = std::max(second, Real(0));
  }
  return {std::min(first, second), std::max(first, second)};
}

bool is_parabola(lobe which) {
  return which == lobe::quadratic_exact || which == lobe::quadratic_published ||
         which == lobe::quadratic_derived;
}

/// Whether value(argument) in Real keeps the bound of its own steps at both arguments, and does not fall from the
/// first to the second by more than these bounds. True where a comparison lies within its own rounding: the tests of
/// the hard points look there.
template <class Real, class Value>
bool bounded_and_rising(const Value& value, Real first, Real second) {
  try {
    const bounded<Real> below = value(bounded<Real>(first));
    const bounded<Real> above = value(bounded<Real>(second));
    const Real low = value(first);
    const Real high = value(second);
    return std::isfinite(low) && std::isfinite(high) && abs(referee(low) - below.value()) <= below.error() &&
           abs(referee(high) - above.value()) <= above.error() &&
           referee(low) <= referee(high) + below.error() + above.error();
  } catch (const undecided&) {
    return true;
  }
}

}  // namespace

TEMPLATE_TEST_CASE("every lobe keeps its bound and rises with the cosine", "[stability][property]", float,
                   double) {
  CHECK(rc::check([] {
    const auto n = static_cast<TestType>(*exponents());
    const auto [low, high] =
        pair_below(static_cast<TestType>(*cosines(n)), static_cast<TestType>(*cosines(n)));
    for (const auto& [which, name] : kLobes) {
      // The parabola falls before it rises; cut at 0, as everywhere but in the formula itself, it does not.
      const auto value = [&, each = which](const auto& c) {
        using real = std::decay_t<decltype(c)>;
        using std::max;
        const real f = evaluate(each, real(n), c);
        return is_parabola(each) ? real(max(f, real(0))) : f;
      };
      if (!bounded_and_rising(value, low, high)) RC_FAIL(std::string(name));
      const TestType peak = evaluate(which, n, TestType(1));
      RC_ASSERT(value(low) <= peak && value(high) <= peak);
      RC_ASSERT(value(low) >= 0);
    }
  }));
}

TEMPLATE_TEST_CASE("the parabola keeps its bound below zero too, and its vertex", "[stability][property]",
                   float, double) {
  CHECK(rc::check([] {
    const auto n = static_cast<TestType>(*exponents());
    const auto c = static_cast<TestType>(*cosines(n));
    for (const auto line :
         {coefficient_line::published, coefficient_line::derived, coefficient_line::exact}) {
      const bounded<TestType> exact = quadratic(line, bounded<TestType>(n), bounded<TestType>(c));
      const TestType value = quadratic(line, n, c);
      RC_ASSERT(abs(referee(value) - exact.value()) <= exact.error());
      const referee a = coefficient(line, referee(n));
      if (a > 1) RC_ASSERT(referee(value) >= -(a - 1) * (a - 1) / (4 * a) - exact.error());
    }
  }));
}

TEMPLATE_TEST_CASE("the angle-based lobe keeps its bound and falls with the angle", "[stability][property]",
                   float, double) {
  CHECK(rc::check([] {
    const auto n = static_cast<TestType>(*exponents());
    const TestType q = static_cast<TestType>(*in_range(0.01, 0.99));
    const auto k = static_cast<TestType>(*exponents());
    const auto limit =
        static_cast<double>(std::min(angle_limit(n, k, q), boost::math::constants::half_pi<TestType>()));
    const auto [low, high] =
        pair_below(static_cast<TestType>(*in_range(0, limit)), static_cast<TestType>(*in_range(0, limit)));
    const auto value = [&](const auto& x) {
      using real = std::decay_t<decltype(x)>;
      return angle_lobe(real(n), real(k), real(q), x);
    };
    RC_ASSERT(bounded_and_rising(value, high, low));
    RC_ASSERT(value(low) <= 1 && value(high) >= 0);
  }));
}

TEST_CASE("the quadratic meets the power at the inflection point", "[stability][property]") {
  CHECK(rc::check([] {
    const referee n = *exponents();
    const referee t = sqrt((n - 1) / n);
    // 50 digits; the roundings are amplified by a (1 - c) / t^n < 2 at most, so 48 are left.
    RC_ASSERT(abs(quadratic(coefficient_line::exact, n, t) - pow(t, n)) < referee("1e-48"));
  }));
}

TEST_CASE("the angle-based lobe takes the value q where the power does", "[stability][property]") {
  CHECK(rc::check([] {
    const double n = *exponents();
    const double k = *exponents();
    const double q = *in_range(0.01, 0.99);
    const double x = angle_of_level(n, q);
    // x and the scale 7 + 15 + 1 roundoffs, k tan(y) y the condition number of cos^k, y = acos(q^(1/k)); the power 5.5
    // times that and 2.
    const double y = angle_of_level(k, q);
    const double roundoffs = 28.5 * k * y * std::tan(y) + 2;
    RC_ASSERT(std::abs(angle_lobe(n, k, q, x) / q - 1) <= roundoffs * 0x1p-53 * (1 + 0x1p-10));
  }));
}

TEST_CASE("the half vector does not tell light from view, and has unit length or none",
          "[stability][property]") {
  CHECK(rc::check([] {
    const auto light = *directions();
    const auto view = *directions();
    const auto h = half_vector(light, view);
    const auto swapped = half_vector(view, light);
    RC_ASSERT(h.x == swapped.x && h.y == swapped.y && h.z == swapped.z);
    const double length = std::sqrt(dot(h, h));
    RC_ASSERT(length == 0 || std::abs(length - 1) <= 8 * 0x1p-53);  // dot 3, sqrt 2, quotient and product 2
  }));
}

TEST_CASE("the mirror direction keeps the angle to the normal", "[stability][property]") {
  CHECK(rc::check([] {
    const auto normal = *directions();
    const auto light = *directions();
    const auto mirror = mirror_direction(normal, light);
    // Unit vectors are off by up to 4 roundoffs in length; 2 (L.N) N - L and the products add a dozen at
    // size 3.
    RC_ASSERT(std::abs(dot(mirror, normal) - dot(light, normal)) <= 48 * 0x1p-53);
  }));
}

TEST_CASE("the energy-safe lobes reflect no more than arrives, at any incidence", "[property]") {
  CHECK(rc::check([] {
    const double n = *exponents();
    const double incidence = *in_range(0, 1.57);
    const auto axis = *rc::gen::element(lobe_axis::half_vector, lobe_axis::mirror);
    const double a = coefficient(coefficient_line::derived, n);
    const auto reflected = [&](lobe which, double root) {
      return with_lobe(which, n,
                       [&](const auto& f) { return reflectance_of_cosine(f, axis, incidence, root); });
    };
    RC_ASSERT(reflected(lobe::quadratic_energy_safe, 1 - 1 / a) <= 1);
    RC_ASSERT(reflected(lobe::cosine_quadratic_energy_safe, 1 - 3 / (n + 1)) <= 1);
  }));
}
