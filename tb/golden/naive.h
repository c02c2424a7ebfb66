// SPDX-License-Identifier: Apache-2.0
/// The formulas as they are printed, evaluated literally: kept so that tests and tables can show what the
/// stable forms are for. Arguments and results as in the stable function of each.
#pragma once

#include <algorithm>
#include <cmath>

#include "tb/golden/scene.h"

namespace blysk::golden::naive {

/// [P] (9); 0/0 at n = 1. Stable: exact_coefficient.
template <class Real>
Real exact_coefficient(const Real& n) {
  using std::atan;
  using std::cos;
  using std::pow;
  using std::sqrt;
  const Real t = cos(Real(atan(Real(1 / sqrt(Real(n - 1))))));
  return (pow(t, Real(n - 1)) - 1) / (t - 1);
}

/// acos(q^(1/n)).   [A]. Stable: angle_of_level.
template <class Real>
Real angle_of_level(const Real& n, const Real& q) {
  using std::acos;
  using std::pow;
  return acos(pow(q, Real(1 / n)));
}

/// n - n c + c.   [T] (2.1). Stable: n (1 - c) + c.
template <class Real>
Real schlick(const Real& n, const Real& c) {
  return c / (n - n * c + c);
}

/// [T] (2.2) by its readings, with the same denominator.
template <class Real>
Real schlick_modified(schlick_reading reading, const Real& n, const Real& c) {
  using std::acos;
  using std::cos;
  Real term = 0;
  switch (reading) {
    case schlick_reading::a:
      term = n * (1 - c * c) / 2;
      break;
    case schlick_reading::b:
      term = n * (1 - c) * (1 - c) / 2;
      break;
    case schlick_reading::c: {
      const Real gamma = acos(c);
      term = n * (1 - cos(gamma * gamma)) / 2;
      break;
    }
    case schlick_reading::d:
      term = n * (1 - c) * n * (1 - c) / 2;
      break;
  }
  return c / (term + n - n * c + c);
}

/// n/2 + (1 - n/2) c^2. Stable: n/2 (1 - c)(1 + c) + c^2.
template <class Real>
Real gx(const Real& n, const Real& c) {
  return c * c / (n / 2 + (1 - n / 2) * c * c);
}

/// a c^2 + (1 - a) c.   [P] (3) (6). Stable: c (1 - a (1 - c)).
template <class Real>
Real quadratic(const Real& a, const Real& c) {
  return a * c * c + (1 - a) * c;
}

/// 1 - cos(y) of reading C of [T] (2.2). Stable: versine.
template <class Real>
Real versine(const Real& y) {
  using std::cos;
  return 1 - cos(y);
}

/// F with g - c as it stands.   Cook and Torrance 1982. Stable: fresnel.
template <class Real>
Real fresnel(const Real& c, const Real& index) {
  using std::sqrt;
  const Real g = sqrt(index * index + c * c - 1);
  const Real quotient = (g - c) / (g + c);
  const Real ratio = (c * (g + c) - 1) / (c * (g - c) + 1);
  return quotient * quotient * (1 + ratio * ratio) / 2;
}

/// Beckmann's D with tan^2 = (1 - c^2)/c^2. Stable: facets.
template <class Real>
Real beckmann(const Real& c, const Real& m) {
  using std::exp;
  return exp(-(1 - c * c) / (c * c * m * m)) / (m * m * c * c * c * c);
}

/// G and only then G / (N . V).   [T] (1.4). Stable: shadowing.
template <class Real>
Real shadowing(const Real& nh, const Real& vh, const Real& nl, const Real& nv) {
  return std::min({Real(1), 2 * nh * nv / vh, 2 * nh * nl / vh}) / nv;
}

/// c^n by its logarithm. Stable: blinn.
template <class Real>
Real power(const Real& n, const Real& c) {
  using std::exp;
  using std::log;
  return exp(n * log(c));
}

/// (n + 6)/(8 pi) c^n as it stands.   [T] fig. 2.16. Stable: blinn_normalised.
template <class Real>
Real blinn_normalised(const Real& n, const Real& c) {
  return (n + 6) / (8 * pi<Real>()) * blinn(n, c);
}

/// cos^k(y) as it stands.   [A]. Stable: angle_lobe_scaled.
template <class Real>
Real angle_lobe_scaled(const Real& k, const Real& y) {
  using std::cos;
  using std::pow;
  return pow(Real(cos(y)), k);
}

/// (L + V) / |L + V|; 0/0 for opposite vectors. Stable: half_vector.
template <class Real>
vec3<Real> half_vector(const vec3<Real>& light, const vec3<Real>& view) {
  using std::sqrt;
  const vec3<Real> sum = light + view;
  return Real(1 / sqrt(dot(sum, sum))) * sum;
}

}  // namespace blysk::golden::naive
