// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/reflectance.h"

#include <algorithm>
#include <cmath>

#include "tb/golden/angle.h"
#include "tb/golden/errors.h"

namespace blysk::golden {

double root_cosine(lobe which, double n) {
  const auto parabola = [n](coefficient_line line) { return 1 - 1 / coefficient(line, n); };
  switch (which) {
    case lobe::quadratic_exact:
      return parabola(coefficient_line::exact);
    case lobe::quadratic_published:
      return parabola(coefficient_line::published);
    case lobe::quadratic_derived:
    case lobe::quadratic_energy_safe:
      return parabola(coefficient_line::derived);
    case lobe::cosine_quadratic:
    case lobe::cosine_quadratic_energy:
    case lobe::cosine_quadratic_energy_safe:
      return 1 - 3 / (n + 1);
    case lobe::lyon_2:
      return 1 - 2 / n;
    case lobe::lyon_4:
      return 1 - 4 / n;
    case lobe::lyon_8:
      return 1 - 8 / n;
    case lobe::rational:
      return 1 - 1 / rational_lobe<double>(n).r;
    default:
      return 0;
  }
}

double lobe_reflectance(lobe which, double n, lobe_axis axis, double incidence_degrees) {
  return reflectance_of_cosine(clamped_lobe(which, n), axis,
                               incidence_degrees * boost::math::constants::degree<double>(),
                               root_cosine(which, n));
}

double lobe_reflectance(lobe which, double n, beyond_right_angle beyond, double incidence_degrees) {
  const double half = lobe_reflectance(which, n, lobe_axis::mirror, incidence_degrees);
  const double incidence = incidence_degrees * boost::math::constants::degree<double>();
  const auto f = clamped_lobe(which, n);
  switch (beyond) {
    case beyond_right_angle::dark:
      break;
    case beyond_right_angle::clipped: {
      const double edge = f(0);
      return half + reflectance_beyond([=](double) { return edge; }, incidence);
    }
    case beyond_right_angle::formula:
      return half + reflectance_beyond([&](double alpha) { return f(std::cos(alpha)); }, incidence);
  }
  return half;
}

double angle_reflectance(double n, double k, double q, double coefficient, lobe_axis axis,
                         double incidence_degrees) {
  const double limit = angle_limit(n, k, q);
  const double scale = angle_scale(n, k, q);
  return coefficient * reflectance([&](double x) { return angle_lobe_scaled(k, scale * x); }, axis,
                                   incidence_degrees * boost::math::constants::degree<double>(),
                                   std::min(limit, boost::math::constants::half_pi<double>()));
}

double cook_torrance_reflectance(facet_distribution distribution, double m, double index,
                                 double incidence_degrees) {
  constexpr double kPi = boost::math::constants::pi<double>();
  using quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
  const double incidence = incidence_degrees * boost::math::constants::degree<double>();
  const vec3<double> normal{0, 0, 1};
  const vec3<double> light{std::sin(incidence), 0, std::cos(incidence)};
  const auto ring = [&](double alpha) {
    const auto point = [&](double phi) {
      const vec3<double> half{std::sin(alpha) * std::cos(phi), std::sin(alpha) * std::sin(phi),
                              std::cos(alpha)};
      const vec3<double> view = mirror_direction(half, light);
      const double oh = dot(light, half);
      if (!(view.z > 0 && oh > 0)) return 0.0;
      return cook_torrance(distribution, m, index, normal, light, view) * view.z * 4 * oh * std::sin(alpha);
    };
    return 2 * quadrature::integrate(point, 0.0, kPi, 5, 1e-7);
  };
  return quadrature::integrate(ring, 0.0, kPi / 2, 8, 1e-7);
}

}  // namespace blysk::golden
