// SPDX-License-Identifier: Apache-2.0
/// Coefficient a of the quadratic a (c^2 - c) + c that replaces c^n.
///
/// Every function template of this directory takes `Real` = float, double or a Boost.Multiprecision
/// number of 50 digits, checks nothing and rounds to nearest at each operation; the registry checks domains.
#pragma once

#include <cmath>

namespace blysk::golden {

/// Which line gives a.
enum class coefficient_line {
  published,  ///< 0.786 n + 0.5, [P] (10) as printed
  derived,    ///< S n - 1/2, the expansion of [P] (9) for large n
  exact,      ///< [P] (9)
};

/// S = 2 (1 - e^(-1/2)) = 0.786938680574733..., the limit of a / n in [P] (9).
template <class Real>
Real coefficient_slope() {
  using std::expm1;
  return -2 * expm1(Real(-1) / 2);
}

/// a = (t^(n-1) - 1) / (t - 1), t = sqrt((n-1)/n) the cosine at the inflection point of cos^n.   [P] (9)
/// As expm1((n-1) l) / expm1(l) with l = ln t = -log1p(1/(n-1)) / 2. No step cancels: n - 1 is exact for
/// n <= 2, and log1p of a positive and expm1 of a negative number do not enlarge relative errors.
/// \param n  specular exponent, [1, 1000]; n = 1, where (9) reads 0/0, gives its limit 0
template <class Real>
Real exact_coefficient(const Real& n) {
  using std::expm1;
  using std::log1p;
  if (n == 1) return Real(0);
  const Real m = n - 1;
  const Real log_t = -log1p(Real(1 / m)) / 2;
  return expm1(Real(m * log_t)) / expm1(log_t);
}

/// a on the given line.   [P] (9) (10)
/// \param n  specular exponent, [1, 1000]
template <class Real>
Real coefficient(coefficient_line line, const Real& n) {
  switch (line) {
    case coefficient_line::published:
      return Real(786) / 1000 * n + Real(1) / 2;
    case coefficient_line::derived:
      return coefficient_slope<Real>() * n - Real(1) / 2;
    case coefficient_line::exact:
      break;
  }
  return exact_coefficient(n);
}

}  // namespace blysk::golden
