// SPDX-License-Identifier: Apache-2.0
// Properties over the whole domain, on random points; the seed is fixed by the test's environment.
#include <rapidcheck.h>

#include <cmath>

#include "tb/catch.h"
#include "tb/golden/angle.h"
#include "tb/golden/energy.h"
#include "tb/golden/lobe.h"
#include "tb/golden/referee.h"
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

rc::Gen<lobe> lobes() {
  return rc::gen::map(rc::gen::inRange<std::size_t>(0, kLobes.size()),
                      [](std::size_t i) { return kLobes[i].which; });
}

rc::Gen<vec3<double>> directions() {
  return rc::gen::map(
      rc::gen::pair(in_range(-1, 1), in_range(0, 6.283185307179586)), [](const std::pair<double, double>& p) {
        const double radius = std::sqrt((1 - p.first) * (1 + p.first));
        return vec3<double>{radius * std::cos(p.second), radius * std::sin(p.second), p.first};
      });
}

}  // namespace

TEST_CASE("every lobe lies between 0 and its value at the peak", "[stability][property]") {
  CHECK(rc::check([] {
    const double n = *exponents();
    const lobe which = *lobes();
    const double peak = evaluate(which, n, 1.0);
    const double value = evaluate(which, n, *cosines(n));
    RC_ASSERT(std::isfinite(value));
    RC_ASSERT(value <= peak);
    const bool parabola = which == lobe::quadratic_exact || which == lobe::quadratic_published ||
                          which == lobe::quadratic_derived;
    const double a = parabola ? coefficient(coefficient_line::published, n) : 0;
    // The parabola's vertex; the published a is the largest of the three, and the value falls with it.
    RC_ASSERT(value >= (parabola ? -(a - 1) * (a - 1) / (4 * a) - 1e-13 * a : 0));
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
    const double k = *rc::gen::inRange(1, 6);
    const double q = *in_range(0.01, 0.99);
    const double x = angle_of_level(n, q);
    // x and the scale 7 + 15 + 1 roundoffs, k tan(y) y the condition number of cos^k, y = acos(q^(1/k)).
    const double y = angle_of_level(k, q);
    const double roundoffs = k * (23 * y * std::tan(y) + 2) + 2;
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
