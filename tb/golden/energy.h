// SPDX-License-Identifier: Apache-2.0
/// Directional-hemispherical reflectance R(L) = integral of f cos(theta_o) d omega_o over the hemisphere; a
/// lobe obeys the conservation of energy where R <= 1.   [T] (2.21) (2.22), [A]
#pragma once

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

namespace blysk::golden {

/// Which angle a lobe's argument is.
enum class lobe_axis {
  half_vector,  ///< between the normal and the half vector: [P], [T], and Blinn's model that [A] imitates
  mirror,       ///< between the outgoing ray and the mirror direction: [A]'s integral takes it so
};

/// What a lobe is beyond 90 degrees from the mirror direction, where its cosine is negative and oblique light still
/// leaves the surface. The half vector never gets there. It matters for lobes that are not 0 at 90 degrees: the
/// cosine-quadratic below n = 2, lyon-K below n = K, the angle-based lobe below n = k.
enum class beyond_right_angle {
  dark,     ///< 0, as Phong's max(0, R . V)^n: what `reflectance` takes
  clipped,  ///< its value at 90 degrees: a device that is given the cosine cut to [0, 1]
  formula,  ///< the formula at the negative cosine, cut at 0
};

/// Weight w(alpha) with R = integral of lobe(alpha) w(alpha) d alpha over [0, pi/2]: the integral over the
/// azimuth around the lobe's axis, in closed form.
///
/// half_vector: d omega_o = 4 (o.h) d omega_h and cos(theta_o) = 2 (o.h) cos(alpha) - cos(theta_i), with
///              o.h = x = a + b cos(phi), a = cos(theta_i) cos(alpha), b = sin(theta_i) sin(alpha).
/// mirror:      cos(theta_o) = a + b cos(phi).
/// Either is integrated as far as cos(theta_o) > 0.
/// \param alpha      angle from the axis, rad; [0, pi/2] for half_vector, [0, pi] for mirror
/// \param incidence  theta_i, rad, [0, pi/2)
inline double reflectance_weight(lobe_axis axis, double alpha, double incidence) {
  const double a = std::cos(incidence) * std::cos(alpha);
  const double b = std::sin(incidence) * std::sin(alpha);
  // cos(theta_o) > 0  <=>  a + b cos(phi) > horizon
  const double horizon = axis == lobe_axis::mirror ? 0 : std::cos(incidence) / (2 * std::cos(alpha));
  if (a + b <= horizon) return 0;
  const double phi = a - b >= horizon ? boost::math::constants::pi<double>() : std::acos((horizon - a) / b);
  const double first = a * phi + b * std::sin(phi);  // integral of x from 0 to phi
  if (axis == lobe_axis::mirror) return 2 * std::sin(alpha) * first;
  const double second =  // integral of x^2
      a * a * phi + 2 * a * b * std::sin(phi) + b * b * (phi / 2 + std::sin(2 * phi) / 4);
  return 8 * std::sin(alpha) * (2 * std::cos(alpha) * second - std::cos(incidence) * first);
}

/// R for a lobe given as a function of its angle, by adaptive Gauss-Kronrod quadrature; for the mirror direction with
/// beyond_right_angle::dark.
/// \param lobe       f(alpha), alpha in rad, [0, pi/2]
/// \param incidence  theta_i, rad, [0, pi/2)
/// \param root       where the lobe ends or has a kink, rad, [0, pi/2]; pi/2 if nowhere
/// \return  R, relative error below 1e-9
template <class Lobe>
double reflectance(const Lobe& lobe, lobe_axis axis, double incidence, double root) {
  constexpr double kHalfPi = boost::math::constants::half_pi<double>();
  const auto integrand = [&](double alpha) {
    return lobe(alpha) * reflectance_weight(axis, alpha, incidence);
  };
  // The weight has a kink where the horizon begins to cut the ring around the axis.
  double cut = kHalfPi - incidence;
  if (axis == lobe_axis::half_vector) cut /= 2;
  const double ends[] = {0, std::min(root, cut), std::max(root, cut), kHalfPi};
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    if (ends[i] < ends[i + 1])
      sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, ends[i], ends[i + 1],
                                                                           12, 1e-10);
  }
  return sum;
}

/// What the angles beyond 90 degrees from the mirror direction add to `reflectance`.
/// \param lobe       f(alpha), alpha in rad, [pi/2, pi/2 + incidence]: the constant f(pi/2) for
///                   beyond_right_angle::clipped, the lobe itself for beyond_right_angle::formula
/// \param incidence  theta_i, rad, [0, pi/2)
/// \return  relative error below 1e-9
template <class Lobe>
double reflectance_beyond(const Lobe& lobe, double incidence) {
  constexpr double kHalfPi = boost::math::constants::half_pi<double>();
  if (!(incidence > 0)) return 0;
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
      [&](double alpha) { return lobe(alpha) * reflectance_weight(lobe_axis::mirror, alpha, incidence); },
      kHalfPi, kHalfPi + incidence, 12, 1e-10);
}

/// R for a lobe given as a function of the cosine of its angle.
/// \param root_cosine  cosine of `root` above, [0, 1]; 0 if nowhere
template <class Lobe>
double reflectance_of_cosine(const Lobe& lobe, lobe_axis axis, double incidence, double root_cosine) {
  return reflectance([&](double alpha) { return lobe(std::cos(alpha)); }, axis, incidence,
                     std::acos(std::clamp(root_cosine, 0.0, 1.0)));
}

}  // namespace blysk::golden
