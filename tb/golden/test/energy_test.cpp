// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/energy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tb/catch.h"
#include "tb/golden/angle.h"
#include "tb/golden/errors.h"
#include "tb/golden/reflectance.h"
#include "tb/golden/shift_division.h"
#include "tb/golden/sphere.h"

using namespace blysk::golden;

namespace {

constexpr double kPi = boost::math::constants::pi<double>();
constexpr double kQuadrature = 1e-9;  // what reflectance() promises, relative

}  // namespace

TEST_CASE("a perfect diffuser reflects what arrives, at any incidence", "[golden][energy]") {
  const auto lambertian = [](double) { return 1 / kPi; };
  for (const double degrees : {0.0, 15.0, 45.0, 60.0, 80.0, 89.0}) {
    CAPTURE(degrees);
    // A kink that is announced but not there changes nothing.
    for (const double root : {kPi / 2, kPi / 6, 0.0}) {
      CHECK(std::abs(reflectance(lambertian, lobe_axis::half_vector, degrees * kPi / 180, root) - 1) <
            kQuadrature);
    }
  }
}

TEST_CASE("reflectance at normal incidence has closed forms", "[golden][energy]") {
  for (const int n : {1, 2, 10, 1000}) {
    const auto power = [n](double c) { return std::pow(c, n); };
    // mirror: 2 pi integral c^(n+1) dc;  half vector: 8 pi integral from sqrt(1/2) of c^(n+1) (2 c^2 - 1) dc
    const double mirror = 2 * kPi / (n + 2);
    const double edge = std::sqrt(0.5);
    const double half =
        8 * kPi * (2 * (1 - std::pow(edge, n + 4)) / (n + 4) - (1 - std::pow(edge, n + 2)) / (n + 2));
    CAPTURE(n);
    CHECK(std::abs(reflectance_of_cosine(power, lobe_axis::mirror, 0, 0) / mirror - 1) < kQuadrature);
    CHECK(std::abs(reflectance_of_cosine(power, lobe_axis::half_vector, 0, 0) / half - 1) < kQuadrature);
  }
}

TEST_CASE("a perfect diffuser around the mirror direction needs the angles beyond 90 degrees",
          "[golden][energy]") {
  const auto lambertian = [](double) { return 1 / kPi; };
  for (const double degrees : {0.0, 15.0, 45.0, 60.0, 80.0, 89.0}) {
    CAPTURE(degrees);
    const double incidence = degrees * kPi / 180;
    const double beyond = reflectance_beyond(lambertian, incidence);
    CHECK(std::abs(reflectance(lambertian, lobe_axis::mirror, incidence, kPi / 2) + beyond - 1) <
          2 * kQuadrature);
    CHECK((beyond > 0) == (degrees > 0));
  }
}

TEST_CASE("three readings of a lobe beyond 90 degrees from the mirror direction", "[golden][energy]") {
  // lyon-8 at n = 1 and 80 degrees, (1 - (1 - c)/8)^8, by the outgoing ray itself: midpoints over both of its angles,
  // in place of rings around the mirror direction.
  const double incidence = 80 * kPi / 180;
  constexpr int kSteps = 1600;
  double dark = 0;
  double clipped = 0;
  double formula = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double square = (i + 0.5) / kSteps;  // sin^2(theta): its step is 2 cos(theta) sin(theta) d theta
    for (int j = 0; j < kSteps; ++j) {
      const double phi = (j + 0.5) / kSteps * kPi;
      const double c = std::sqrt(square) * std::cos(phi) * std::sin(incidence) +
                       std::sqrt(1 - square) * std::cos(incidence);
      dark += c > 0 ? std::pow((7 + c) / 8, 8) : 0;
      clipped += std::pow((7 + std::max(c, 0.0)) / 8, 8);
      formula += std::pow((7 + c) / 8, 8);
    }
  }
  const double cell = kPi / kSteps / kSteps;
  const auto f = [](double alpha) { return lyon<8>(1.0, std::cos(alpha)); };
  const double half = reflectance(f, lobe_axis::mirror, incidence, kPi / 2);
  const double at_right_angle = f(kPi / 2);
  const double by_formula = half + reflectance_beyond(f, incidence);
  const double by_clipping = half + reflectance_beyond([=](double) { return at_right_angle; }, incidence);
  // Midpoints: the smooth integrands to their square, 1/kSteps^2; the step at 90 degrees crosses kSteps cells or so,
  // whose errors, at most f(pi/2) each, have no common sign.
  CHECK(std::abs(half - dark * cell) < at_right_angle * kPi / kSteps);
  CHECK(std::abs(by_clipping - clipped * cell) < 10.0 / kSteps / kSteps);
  CHECK(std::abs(by_formula - formula * cell) < 10.0 / kSteps / kSteps);
  CHECK(std::abs(half - 1.102) < 5e-4);
  CHECK(std::abs(by_clipping - 1.548) < 5e-4);
  CHECK(std::abs(by_formula - 1.398) < 5e-4);
  const auto named = [](beyond_right_angle beyond) { return lobe_reflectance(lobe::lyon_8, 1, beyond, 80); };
  CHECK(std::abs(named(beyond_right_angle::dark) / half - 1) < kQuadrature);
  CHECK(std::abs(named(beyond_right_angle::clipped) / by_clipping - 1) < kQuadrature);
  CHECK(std::abs(named(beyond_right_angle::formula) / by_formula - 1) < kQuadrature);
}

TEST_CASE("the exact coefficient normalises the integral it comes from", "[golden][energy]") {
  for (const double q : {0.1, 0.5, 0.9}) {
    for (const double k : {1.0, 5.0}) {
      const double n = 50;
      const auto f = [=](double x) { return angle_coefficient_exact(n, k, q) * angle_lobe(n, k, q, x); };
      CAPTURE(q, k);
      CHECK(std::abs(reflectance(f, lobe_axis::mirror, 0, angle_limit(n, k, q)) - 1) < kQuadrature);
    }
  }
}

TEST_CASE("the energy factors are what their bound says", "[golden][energy]") {
  // 1 / (8 pi integral of the lobe); the lobes are polynomials, so 16-point quadrature up to the root is
  // exact.
  using quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
  for (const double a : {0.25, 0.75, 1.0, 1.5, 10.0, 786.5}) {
    const double root = a < 1 ? 0 : 1 - 1 / a;
    const double integral = quadrature::integrate([a](double c) { return quadratic(a, c); }, root, 1.0);
    CAPTURE(a);
    // 1 - a (1 - c) inherits a times the roundoff of c.
    CHECK(std::abs(quadratic_energy_factor(a) * 8 * kPi * integral - 1) < 64 * (1 + a) * 0x1p-53);
  }
}

TEST_CASE("the energy factors' branches and limits are those of docs/numerics.md", "[golden][energy]") {
  // Both branches of the parabola's factor meet at a = 1: 3/(8 pi), slopes 3/(16 pi).
  const double h = 0x1p-20;
  const auto factor = [](double a) { return quadratic_energy_factor(a); };
  CHECK(std::abs(factor(1) - 3 / (8 * kPi)) < 4 * 0x1p-53);
  // A one-sided difference is off by h/2 times the second derivative, below 1, and 2^-53 / h.
  CHECK(std::abs((factor(1) - factor(1 - h)) / h - 3 / (16 * kPi)) < h);
  CHECK(std::abs((factor(1 + h) - factor(1)) / h - 3 / (16 * kPi)) < h);
  // The cosine-quadratic's integral over c is 1/(n + 1) from n = 2 on, and less below.
  using quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
  for (const double n : {1.0, 1.5, 1.99, 2.0, 7.0, 1000.0}) {
    const double root = std::max(0.0, 1 - 3 / (n + 1));
    const double integral =
        quadrature::integrate([n](double c) { return cosine_quadratic(n, c); }, root, 1.0);
    CAPTURE(n);
    if (n < 2) {
      CHECK(integral < 1 / (n + 1) - 1e-9);
    } else {
      CHECK(std::abs(integral * (n + 1) - 1) < 64 * n * 0x1p-53);
    }
  }
  // How close the bounds are, in the digits that the page states.
  const auto r = [](lobe which, double n) { return lobe_reflectance(which, n, lobe_axis::half_vector, 0); };
  CHECK(std::abs(r(lobe::quadratic_energy_safe, 1000) - 0.998) < 5e-4);
  CHECK(std::abs(r(lobe::cosine_quadratic_energy_safe, 1000) - 0.996) < 5e-4);
  CHECK(std::abs(r(lobe::quadratic_energy_safe, 1) - 0.25) < 5e-3);
  CHECK(std::abs(r(lobe::cosine_quadratic_energy_safe, 1) - 0.22) < 5e-3);
}

TEST_CASE("the largest error of a known function is found where it lies", "[golden][errors]") {
  const auto bump = [](double c) { return 1 - 1e6 * (c - 0.9912) * (c - 0.9912); };
  const peak found = largest(bump, 300, 0, 1);
  CHECK(std::abs(found.cos - 0.9912) <
        1e-6);  // Brent's method stops at half the digits, scaled by sqrt(1/1e6)
  CHECK(std::abs(found.value - 1) < 1e-6);
  // c^1 against Schlick's lobe at n = 1, which is c itself: the denominator's rounding is left.
  CHECK(largest_absolute_error(clamped_lobe(lobe::schlick, 1), 1, 0).value <= 4 * 0x1p-53);
  // rms of 0 against c: sqrt(1/3).
  CHECK(std::abs(rms_error([](double) { return 0; }, 1) - std::sqrt(1.0 / 3)) < 1e-9);
}

TEST_CASE("where an epicentre ends, and errors in it", "[golden][errors]") {
  // Square roots and a seventh root, by hand.
  CHECK(epicentre_edge(epicentre::level_060, 2) == Approx(0.77459666924148338).epsilon(1e-15));
  CHECK(epicentre_edge(epicentre::level_056, 2) == Approx(0.74833147735478828).epsilon(1e-15));
  CHECK(epicentre_edge(epicentre::inflection, 100) == Approx(0.99498743710661995).epsilon(1e-15));
  CHECK(std::abs(std::pow(epicentre_edge(epicentre::level_060, 7), 7) - 0.6) < 16 * 0x1p-53);
  CHECK(std::abs(std::pow(epicentre_edge(epicentre::level_056, 1000), 1000) - 0.56) < 1100 * 0x1p-53);
  // What is a tenth too large is so relative to c^n, and absolutely at the peak.
  const auto larger = [](double c) { return 1.1 * c * c; };
  CHECK(std::abs(largest_relative_error(larger, 2, 0.5).value - 0.1) < 8 * 0x1p-53);
  CHECK(std::abs(largest_absolute_error(larger, 2, 0.5).value - 0.1) < 8 * 0x1p-53);
  CHECK(clamped_lobe(lobe::quadratic_published, 1000)(0.5) == 0);
  CHECK(clamped_lobe(lobe::quadratic_published, 2)(1) == 1);
}

TEST_CASE("an error that peaks in a kink is found for every exponent", "[golden][errors]") {
  // For n >= 3 the clamped parabola is furthest from c^n where it ends; Brent's method places the kink to
  // 2^-26, and c^n falls by no more than n times that.
  for (int n = 3; n <= 1000; ++n) {
    const double root = 1 - 1 / coefficient<double>(coefficient_line::derived, n);
    const peak found = largest_absolute_error(clamped_lobe(lobe::quadratic_derived, n), n, 0);
    CAPTURE(n, found.cos, root);
    REQUIRE(found.value >= blinn<double>(n, root) - n * 0x1p-26);
  }
}

TEST_CASE("an error narrower than a step of the whole range is found beside the peak", "[golden][errors]") {
  // At n = 1000 a step over [0, 1] is 0.005, one beside the peak 40/1000/200 = 0.0002.
  const auto spike = [](double c) { return std::max(0.0, 1 - std::abs(c - 0.9985) / 0.0003); };
  const peak found = largest(spike, 1000, 0, 1);
  CHECK(std::abs(found.cos - 0.9985) < 1e-7);
  CHECK(std::abs(found.value - 1) < 1e-3);
}

TEST_CASE("NMSE is a share of the reference's energy", "[golden][sphere]") {
  const std::vector<double> reference{1, 2, 2};
  const std::vector<double> doubled{2, 4, 4};
  CHECK(nmse(reference, reference) == 0);
  CHECK(nmse(reference, doubled) == 1);
  CHECK(nmse(doubled, reference) == 0.25);
}

TEST_CASE("the sphere is round, faces the viewer and peaks where the normal is the half vector",
          "[golden][sphere]") {
  sphere_scene scene;
  scene.side = 64;
  const auto pixels = sphere_pixels(scene);
  for (const auto& pixel : pixels) {
    REQUIRE(pixel.normal.z > 0);
    REQUIRE(std::abs(dot(pixel.normal, pixel.normal) - 1) <= 8 * 0x1p-53);
  }
  const auto picture = shade_sphere(scene, {1, 1, 0, 0, 1}, lobe::blinn, 100);
  const auto brightest = static_cast<std::size_t>(std::ranges::max_element(picture) - picture.begin());
  const auto half_vec = half_vector(scene.light, scene.view);
  // H along (0.4, 0.5, 0.75 + |(0.4, 0.5, 0.75)|) is (0.2161, 0.2702, ...): (1 + 0.9 x) 32 and (1 - 0.9 y) 32 are 38.2
  // and 24.2, in pixels.
  CHECK(pixels[brightest].x == 38);
  CHECK(pixels[brightest].y == 24);
  // A light of 2 with a specular share of 1/4: half as bright.
  const auto half_as_bright = shade_sphere(scene, {1, 2, 0, 0, 0.25}, lobe::blinn, 100);
  CHECK(half_as_bright[brightest] == picture[brightest] / 2);
  // Rows run downwards and columns to the right: the light comes from above on the right.
  CHECK(pixels[brightest].y < scene.side / 2);
  CHECK(pixels[brightest].x >= scene.side / 2);
  for (const auto& pixel : pixels) {
    REQUIRE((pixel.normal.y > 0) == (pixel.y < scene.side / 2));
    REQUIRE((pixel.normal.x > 0) == (pixel.x >= scene.side / 2));
  }
  // Half a pixel off the axis the normal leans by sqrt(2) / 64 / 0.9; and the radius is 0.9 of half a side.
  const auto middle = std::ranges::max_element(pixels, {}, [](const auto& pixel) { return pixel.normal.z; });
  CHECK(std::abs(1 - middle->normal.z - 1 / (64 * 64 * 0.81)) < 1e-6);
  CHECK((middle->x == 31 || middle->x == 32));
  CHECK(pixels.front().y == 3);  // (1 - 0.9) 64 / 2 = 3.2: the row whose centre is 3.5 pixels down
  CHECK(pixels.back().y == 60);
  // No normal is nearer to the half vector than that of the brightest pixel.
  for (const auto& pixel : pixels) {
    REQUIRE(dot(pixel.normal, half_vec) <= dot(pixels[brightest].normal, half_vec));
  }
}

TEST_CASE("division by shifts rounds 1/k to the nearest number of its places", "[golden][shifts]") {
  CHECK(reciprocal_digits(7, 6) == 0b001001);  // 1/8 + 1/64, [T] (2.19)
  for (uint32_t k = 2; k <= 1000; ++k) {
    for (int places = 1; places <= 16; ++places) {
      CAPTURE(k, places);
      // |digits / 2^places - 1/k| <= 2^-(places + 1), in whole numbers.
      const auto error = std::abs(int64_t{reciprocal_digits(k, places)} * k - (int64_t{1} << places));
      REQUIRE(2 * error <= k);
    }
  }
  CHECK(shifted_quotient(255, 7, 6) == 255 * 9 / 64.0);
}
