// SPDX-License-Identifier: Apache-2.0
/// The formulas as they are printed, evaluated literally: kept so that tests and tables can show what the
/// stable forms are for. Arguments and results as in the stable function of each.
#pragma once

#include <cmath>

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

/// 1 - cos(y) of reading C of [T] (2.2). Stable: 2 sin^2(y / 2).
template <class Real>
Real versine(const Real& y) {
  using std::cos;
  return 1 - cos(y);
}

}  // namespace blysk::golden::naive
