// SPDX-License-Identifier: Apache-2.0
/// Specular lobes: cos^n and what the seeds, and hardware that shipped, put in its place.
///
/// Common to all: n is the specular exponent in [1, 1000]; c = cos(delta), delta = angle(normal, half_vec),
/// in [0, 1]; the result is a dimensionless factor, without the cosine of the lighting equation.
/// 1 - c is formed first wherever a formula allows it: it is exact for c >= 1/2, where the lobe lies.
#pragma once

#include "tb/golden/coefficient.h"
#include "tb/golden/pi.h"

namespace blysk::golden {

/// c^n.   [P] (1), [T] (2.11). In [0, 1]; underflows to 0 gracefully.
template <class Real>
Real blinn(const Real& n, const Real& c) {
  using std::pow;
  return pow(c, n);
}

/// (n + 6) / (8 pi) c^n.   [T] fig. 2.16. In [0, (n + 6) / (8 pi)].
/// By c^(n/2) twice: c^n may leave the normal numbers, and lose its digits, where the factor lifts the product back.
template <class Real>
Real blinn_normalised(const Real& n, const Real& c) {
  const Real half = blinn(Real(n / 2), c);
  return (n + 6) / (8 * pi<Real>()) * half * half;
}

/// c / (n - n c + c), its denominator as n (1 - c) + c.   [T] (1.5) (2.1). In [0, 1].
template <class Real>
Real schlick(const Real& n, const Real& c) {
  return c / (n * (1 - c) + c);
}

/// Angle whose cosine is c, as 2 asin(sqrt((1 - c) / 2)): it shows what a good acos does near the peak, and depends on
/// none.
/// \return  rad, [0, pi / 2] for c in [0, 1]
template <class Real>
Real angle_of_cosine(const Real& c) {
  using std::asin;
  using std::sqrt;
  return 2 * asin(sqrt(Real((1 - c) / 2)));
}

/// 1 - cos(y) as 2 sin^2(y / 2). In [0, 2].
template <class Real>
Real versine(const Real& y) {
  using std::sin;
  const Real s = sin(Real(y / 2));
  return 2 * s * s;
}

/// cos^a x / (n - n cos x + cos x), the form of [T] table 3.2 and section 3.4; its a is given nowhere.
/// In [0, 1].
/// \param a  power of the cosine, >= 0
template <class Real>
Real schlick_power(const Real& n, const Real& a, const Real& c) {
  using std::pow;
  return pow(c, a) / (n * (1 - c) + c);
}

/// What [T] (2.2) prints as "0.5 n (1 - cos gamma^2)", gamma = acos(c), can be read in four ways.
enum class schlick_reading {
  a,  ///< n (1 - c^2) / 2
  b,  ///< n (1 - c)^2 / 2
  c,  ///< n (1 - cos(gamma^2)) / 2
  d,  ///< (n (1 - c))^2 / 2, the one reading that meets the 3.2 % of [T], and that from n = 2 on
};

/// c / (t + n - n c + c), t the term of the given reading.   [T] (2.2). In [0, 1].
template <class Real>
Real schlick_modified(schlick_reading reading, const Real& n, const Real& c) {
  const Real u = 1 - c;
  Real term = 0;
  switch (reading) {
    case schlick_reading::a:
      term = n * u * (1 + c) / 2;
      break;
    case schlick_reading::b:
      term = n * u * u / 2;
      break;
    case schlick_reading::c: {
      const Real gamma = angle_of_cosine(c);
      term = n * versine(Real(gamma * gamma)) / 2;
      break;
    }
    case schlick_reading::d:
      term = n * u * n * u / 2;
      break;
  }
  return c / (term + n * u + c);
}

/// a (c^2 - c) + c = c (1 - a (1 - c)), the second form so that the root is sharp.   [P] (3) (6)
/// Not limited: negative for 0 < c < 1 - 1/a, down to -(a - 1)^2 / (4a). At most 1.
/// \param a  coefficient, >= 0
template <class Real>
Real quadratic(const Real& a, const Real& c) {
  return c * (1 - a * (1 - c));
}

/// The same with a on the given line.   [P] (3) (6) (9) (10)
template <class Real>
Real quadratic(coefficient_line line, const Real& n, const Real& c) {
  return quadratic(coefficient(line, n), c);
}

/// Factor that keeps the reflectance of max(0, quadratic) at or below 1 for every incidence and every a >= 0:
/// 1 / (8 pi integral_0^1 max(0, a (c^2 - c) + c) dc); docs/numerics.md has the proof.
template <class Real>
Real quadratic_energy_factor(const Real& a) {
  if (a < 1) return 3 / (4 * pi<Real>() * (3 - a));
  return 3 * a * a / (4 * pi<Real>() * (3 * a - 1));
}

/// quadratic_energy_factor(a) max(0, a (c^2 - c) + c). In [0, quadratic_energy_factor(a)].
template <class Real>
Real quadratic_energy_safe(const Real& a, const Real& c) {
  const Real lobe = quadratic(a, c);
  return lobe > 0 ? Real(quadratic_energy_factor(a) * lobe) : Real(0);
}

/// ((n + 1)/3 (c - 1) + 1)^2, zero beyond its root c = 1 - 3/(n + 1).   [T] (2.15). In [0, 1].
template <class Real>
Real cosine_quadratic(const Real& n, const Real& c) {
  const Real root_distance = 1 - (n + 1) / 3 * (1 - c);
  return root_distance > 0 ? Real(root_distance * root_distance) : Real(0);
}

/// (n + 6)/24.55 times the cosine-quadratic.   [T] (2.26). In [0, (n + 6) / 24.55].
template <class Real>
Real cosine_quadratic_energy(const Real& n, const Real& c) {
  return (n + 6) * 100 / 2455 * cosine_quadratic(n, c);
}

/// (n + 1)/(8 pi) times the cosine-quadratic: reflectance at or below 1 for every incidence and every n >= 1;
/// docs/numerics.md has the proof. In [0, (n + 1) / (8 pi)].
template <class Real>
Real cosine_quadratic_energy_safe(const Real& n, const Real& c) {
  return (n + 1) / (8 * pi<Real>()) * cosine_quadratic(n, c);
}

/// x^K, K a power of two, by squaring.
template <int K, class Real>
Real squared(const Real& x) {
  static_assert(K >= 1 && (K & (K - 1)) == 0);
  if constexpr (K == 1) {
    return x;
  } else {
    const Real root = squared<K / 2>(x);
    return root * root;
  }
}

/// (1 - n (1 - c) / K)^K, zero beyond its root c = 1 - K/n; K = 2, 4, 8. In [0, 1].
/// R. Lyon, Phong Shading Reformulation for Hardware Renderer Simplification, Apple TR 43, 1993.
template <int K, class Real>
Real lyon(const Real& n, const Real& c) {
  const Real root_distance = 1 - n * (1 - c) / K;
  return root_distance > 0 ? squared<K>(root_distance) : Real(0);
}

/// c^2 / (n/2 + (1 - n/2) c^2), the quadratic over quadratic of the GameCube's GX lighting unit.
/// Its denominator is formed as n/2 (1 - c)(1 + c) + c^2. In [0, 1].
template <class Real>
Real gx(const Real& n, const Real& c) {
  const Real c2 = c * c;
  return c2 / (n / 2 * (1 - c) * (1 + c) + c2);
}

/// Rational lobe (1 - r u) / (1 - r u + s u), u = 1 - c: its peak is exactly 1 and it ends at its root u =
/// 1/r. As (c + p0) / (p1 c + p2): p0 = 1/r - 1, p1 = 1 - s/r, p2 = (1 + s)/r - 1.
template <class Real>
struct rational_lobe {
  Real r;  ///< reciprocal of the distance 1 - c of the root from the peak
  Real s;  ///< slope at the peak

  /// Meets c^n at the levels 0.425856 and 0.050698: there the error of (1 - r y)/(1 - r y + s y) against e^-y, the
  /// limit of large n, vanishes where its maximum, 0.024798, is least (docs/numerics.md has the proof).
  explicit rational_lobe(const Real& n) {
    using std::expm1;
    using std::log;
    // At level v, u = 1 - v^(1/n):   r u (1 - v) + s u v = 1 - v.
    const Real v0 = Real(425856) / 1000000;
    const Real v1 = Real(50698) / 1000000;
    const Real u0 = -expm1(Real(log(v0) / n));
    const Real u1 = -expm1(Real(log(v1) / n));
    const Real ratio0 = v0 / (1 - v0);
    const Real ratio1 = v1 / (1 - v1);
    s = (1 / u0 - 1 / u1) / (ratio0 - ratio1);
    r = 1 / u0 - s * ratio0;
  }

  /// In [0, 1], zero beyond the root.
  Real operator()(const Real& c) const {
    const Real u = 1 - c;
    const Real numerator = 1 - r * u;
    return numerator > 0 ? Real(numerator / (numerator + s * u)) : Real(0);
  }
};

/// rational_lobe(n) at c. In [0, 1].
template <class Real>
Real rational(const Real& n, const Real& c) {
  return rational_lobe<Real>(n)(c);
}

}  // namespace blysk::golden
