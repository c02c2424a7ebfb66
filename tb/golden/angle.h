// SPDX-License-Identifier: Apache-2.0
/// The angle-based lobe of [A] and its energy normalisation.
///
/// Common to all: n the exponent of the lobe that is imitated, [1, 1000]; k the low exponent, >= 1;
/// q the value of cos^n at which both meet, (0, 1); x the angle from the lobe's axis, rad, [0, pi/2].
#pragma once

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <span>

#include "tb/golden/pi.h"

namespace blysk::golden {

/// acos(q^(1/n)) as 2 asin(sqrt(-expm1(ln(q) / n) / 2)): q^(1/n) near 1 would lose the angle.   rad
template <class Real>
Real angle_of_level(const Real& n, const Real& q) {
  using std::asin;
  using std::expm1;
  using std::log;
  using std::sqrt;
  return 2 * asin(sqrt(Real(-expm1(Real(log(q) / n)) / 2)));
}

/// acos(q^(1/k)) / acos(q^(1/n)), the factor of the angle.   [A], 4th formula
template <class Real>
Real angle_scale(const Real& n, const Real& k, const Real& q) {
  return angle_of_level(k, q) / angle_of_level(n, q);
}

/// Angle at which the lobe reaches zero, "gran" of [A]; above pi/2 when n < k.   rad
template <class Real>
Real angle_limit(const Real& n, const Real& k, const Real& q) {
  return pi<Real>() / 2 / angle_scale(n, k, q);
}

/// cos^k(y), zero from pi/2 on, y = angle_scale x. In [0, 1].
/// Below pi/4 as exp(k ln(1 - sin^2 y) / 2): cos(y) near 1 rounds away what a large k multiplies. Above as it stands:
/// there ln(1 - sin^2 y) would cancel, and cos(y) is off by no more than k tan(y) y has anyway.
template <class Real>
Real angle_lobe_scaled(const Real& k, const Real& y) {
  using std::cos;
  using std::exp;
  using std::log1p;
  using std::pow;
  using std::sin;
  if (y < pi<Real>() / 4) {
    const Real s = sin(y);
    return exp(Real(k / 2 * log1p(Real(-(s * s)))));
  }
  return y < pi<Real>() / 2 ? Real(pow(Real(cos(y)), k)) : Real(0);
}

/// cos^k(angle_scale x), zero from angle_limit on.   [A], 4th formula. In [0, 1].
template <class Real>
Real angle_lobe(const Real& n, const Real& k, const Real& q, const Real& x) {
  return angle_lobe_scaled(k, Real(angle_scale(n, k, q) * x));
}

/// The lobe over a whole picture: out[i] = angle_lobe(n, k, q, angles[i]), bit for bit; what depends on n, k and q alone
/// is computed once.
/// \param angles  rad, each in [0, pi/2]
/// \param out     as long as angles
/// \throws std::domain_error  n outside [1, 1000], k below 1, q outside (0, 1), or the lengths differ
void angle_lobe(double n, double k, double q, std::span<const double> angles, std::span<double> out);
void angle_lobe(float n, float k, float q, std::span<const float> angles, std::span<float> out);

/// integral from 0 to `end` of cos^k(y) sin(2 y / scale) dy, `end` in [0, pi/2], by tanh-sinh quadrature: its nodes
/// crowd at both ends, where cos^k is singular for k that is not whole (pi/2) and where it is narrow for large k (0).
template <class Real>
Real angle_moment(const Real& k, const Real& scale, const Real& end) {
  using std::sin;
  static boost::math::quadrature::tanh_sinh<Real> rule;  // finds its nodes once; it locks while it adds some
  return rule.integrate(
      [&](const Real& y) { return Real(angle_lobe_scaled(k, y) * sin(Real(2 * y / scale))); }, Real(0), end);
}

/// Int = integral from 0 to `limit` of cos^k(angle_scale x) cos x sin x dx, `limit` <= angle_limit.   [A]
template <class Real>
Real angle_integral(const Real& n, const Real& k, const Real& q, const Real& limit) {
  using std::min;
  const Real scale = angle_scale(n, k, q);
  return angle_moment(k, scale, min(Real(scale * limit), Real(pi<Real>() / 2))) / (2 * scale);
}

/// 1 / (2 pi Int), Int up to angle_limit as [A] has it, even where that passes pi/2.   [A]
template <class Real>
Real angle_coefficient_exact(const Real& n, const Real& k, const Real& q) {
  const Real scale = angle_scale(n, k, q);
  return scale / (pi<Real>() * angle_moment(k, scale, Real(pi<Real>() / 2)));
}

/// 1 / (8 pi integral from 0 to angle_limit, at most pi/2, of cos^k(angle_scale x) sin x dx): keeps the reflectance at or below
/// 1 at every incidence, with x from the half vector and from the mirror direction.   docs/numerics.md
template <class Real>
Real angle_coefficient_safe(const Real& n, const Real& k, const Real& q) {
  using std::min;
  const Real scale = angle_scale(n, k, q);
  const Real end = pi<Real>() / 2 * min(scale, Real(1));
  return scale / (8 * pi<Real>() * angle_moment(k, Real(2 * scale), end));
}

/// Fitted normalisation, one formula for q in [0.1, 0.4], another for q in [0.5, 0.9].   [A]
/// The gap between them, and n <= k, are outside the fit.
template <class Real>
Real angle_coefficient_fitted(const Real& n, const Real& k, const Real& q) {
  const Real milli = Real(1) / 1000;
  if (q < Real(9) / 20)
    return 608 * milli * n * (q - 193 * milli) / (2 * (q + k)) + 161 * milli * n + 284 * milli;
  return 743 * milli * q * (167 * milli * n - 133 * milli / 10 * k * n) / k + 167 * milli * n + 245 * milli;
}

}  // namespace blysk::golden
