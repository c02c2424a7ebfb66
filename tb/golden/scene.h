// SPDX-License-Identifier: Apache-2.0
/// Lighting of one surface point from vectors: Lambert, Phong, Blinn and any other lobe, Cook-Torrance.
///
/// Common to all: normal, light and view are unit vectors away from the surface; results are dimensionless.
/// Behind the surface: where normal . light <= 0 the light adds nothing; where normal . view <= 0 it adds no
/// specular part. Both are exact at grazing: a lobe that does not carry the cosine ends there with a step.
#pragma once

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <type_traits>

#include "tb/golden/lobe.h"

namespace blysk::golden {

template <class Real>
struct vec3 {
  Real x, y, z;

  friend vec3 operator+(const vec3& a, const vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend vec3 operator-(const vec3& a, const vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend vec3 operator*(const Real& s, const vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

template <class Real>
Real dot(const vec3<Real>& a, const vec3<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The direction of a vector whose square leaves the normal numbers: scaled by a power of two, which rounds nothing,
/// to a largest component in [1, 2). Infinite components outweigh the others and count as equal.
/// \return  a unit vector; zero for the zero vector and for one with a NaN, which have no direction
template <class Real>
vec3<Real> direction_of_extreme(const vec3<Real>& a) {
  static_assert(std::is_floating_point_v<Real>);
  const Real largest = std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
  if (std::isnan(a.x) || std::isnan(a.y) || std::isnan(a.z) || largest == 0) return {0, 0, 0};
  const auto scaled = [&](Real component) {
    if (std::isinf(largest)) return std::isinf(component) ? std::copysign(Real(1), component) : Real(0);
    return std::scalbn(component, -std::ilogb(largest));
  };
  const vec3<Real> b{scaled(a.x), scaled(a.y), scaled(a.z)};
  return Real(1 / std::sqrt(dot(b, b))) * b;
}

/// a / |a|. The zero vector for zero and for a NaN: a picture then has no light there rather than no number.
template <class Real>
vec3<Real> normalised(const vec3<Real>& a) {
  using std::sqrt;
  const Real square = dot(a, a);
  if constexpr (std::is_floating_point_v<Real>) {
    // Below, components vanish whose squares would count; above, the square is infinite.
    constexpr Real kLeast = std::numeric_limits<Real>::min() / std::numeric_limits<Real>::epsilon();
    if (!(square >= kLeast && square <= std::numeric_limits<Real>::max())) return direction_of_extreme(a);
  } else {
    if (!(square > 0)) return a;
  }
  return Real(1 / Real(sqrt(square))) * a;
}

/// cos of the angle between unit vectors, cut to [0, 1]: rounding may put it a little outside, and a negative
/// one is behind the surface.
template <class Real>
Real clamped_cosine(const vec3<Real>& a, const vec3<Real>& b) {
  using std::clamp;
  return clamp(dot(a, b), Real(0), Real(1));
}

/// H = (L + V) / |L + V|.   [P] (2), [A]
/// The zero vector where L + V is nothing but the rounding of two opposite unit vectors (each component of
/// either is off by at most epsilon, the sum of both by 2 sqrt(3) epsilon < 4 epsilon): then N . H is 0.
template <class Real>
vec3<Real> half_vector(const vec3<Real>& light, const vec3<Real>& view) {
  const vec3<Real> sum = light + view;
  const Real noise = 4 * std::numeric_limits<Real>::epsilon();
  if (dot(sum, sum) <= noise * noise) return {Real(0), Real(0), Real(0)};
  return normalised(sum);
}

/// R = 2 (L . N) N - L.   [T] (2.10)
template <class Real>
vec3<Real> mirror_direction(const vec3<Real>& normal, const vec3<Real>& light) {
  return Real(2 * dot(light, normal)) * normal - light;
}

/// True where the light reaches the side of the surface that the viewer sees.
template <class Real>
bool faces_both(const vec3<Real>& normal, const vec3<Real>& light, const vec3<Real>& view) {
  return dot(normal, light) > 0 && dot(normal, view) > 0;
}

/// Intensities of the light and shares of the material; every member >= 0.   [T] (1.2)
template <class Real>
struct illumination {
  Real ambient_light;  ///< I_a
  Real point_light;    ///< I_l
  Real ka, kd, ks;     ///< ambient, diffuse and specular share
};

/// I_a k_a + I_l k_d max(0, N . L).   [T] (1.2) without its specular term
template <class Real>
Real lambert(const illumination<Real>& i, const vec3<Real>& normal, const vec3<Real>& light) {
  return i.ambient_light * i.ka + i.point_light * i.kd * clamped_cosine(normal, light);
}

/// Lambert + I_l k_s (R . V)^n.   [T] (1.2) (2.9)
/// \param n  specular exponent, [1, 1000]
template <class Real>
Real phong(const illumination<Real>& i, const Real& n, const vec3<Real>& normal, const vec3<Real>& light,
           const vec3<Real>& view) {
  Real base = lambert(i, normal, light);
  if (!faces_both(normal, light, view)) return base;
  return base + i.point_light * i.ks * blinn(n, clamped_cosine(mirror_direction(normal, light), view));
}

/// max(0, lobe(N . H)): light is not negative, so a negative lobe is cut as the devices cut it. 0 where light
/// or view is behind the surface, and where they are opposite: then N . H is 0, which not every lobe sends to 0.
/// \param lobe  f(cos(delta))
template <class Real, class Lobe>
Real highlight(const Lobe& lobe, const vec3<Real>& normal, const vec3<Real>& light, const vec3<Real>& view) {
  using std::max;
  if (!faces_both(normal, light, view)) return Real(0);
  const Real nh = clamped_cosine(normal, half_vector(light, view));
  return nh > 0 ? max(Real(lobe(nh)), Real(0)) : Real(0);
}

/// Lambert + I_l k_s max(0, lobe(n, N . H)).   [P] (1), [T] (2.11); lobe::blinn is Blinn's model itself
/// \param n  specular exponent, [1, 1000]
template <class Real>
Real half_vector_shading(lobe which, const illumination<Real>& i, const Real& n, const vec3<Real>& normal,
                         const vec3<Real>& light, const vec3<Real>& view) {
  return with_lobe(which, n, [&](const auto& f) {
    return Real(lambert(i, normal, light) + i.point_light * i.ks * highlight(f, normal, light, view));
  });
}

/// Distribution D of the facets' normals around N, alpha their angle to it.   [T] (1.4)
enum class facet_distribution {
  gaussian,  ///< exp(-(alpha / m)^2)
  beckmann,  ///< exp(-(tan(alpha) / m)^2) / (m^2 cos^4(alpha))
};

/// \param c  cos(alpha), [0, 1]
/// \param m  root mean square slope of the facets, (0, 1]
template <class Real>
Real facets(facet_distribution which, const Real& c, const Real& m) {
  using std::exp;
  if (which == facet_distribution::gaussian) {
    const Real alpha = angle_of_cosine(c);
    return exp(Real(-(alpha / m) * (alpha / m)));
  }
  const Real c2 = c * c;
  const Real divisor = m * m * c2 * c2;
  if (!(divisor > 0)) return Real(0);  // c is 0 or underflows, and the exponential wins over c^-4
  // The root of the exponential twice: the exponential itself may leave the normal numbers where the divisor, down to
  // m^2 c^4, lifts the quotient back.
  const Real tan2 = (1 - c) * (1 + c) / c2;
  const Real root = exp(Real(-tan2 / (2 * m * m)));
  return root / divisor * root;
}

/// Reflectance F of a smooth dielectric for unpolarised light (Cook and Torrance 1982).   In [0, 1].
///   F = ((g - c)/(g + c))^2 (1 + ((c (g + c) - 1)/(c (g - c) + 1))^2) / 2,   g^2 = index^2 + c^2 - 1
/// \param c      cos of the angle between light and half vector, [0, 1]
/// \param index  relative index of refraction, > 1
template <class Real>
Real fresnel(const Real& c, const Real& index) {
  using std::sqrt;
  // index^2 - 1 as a product, and g - c as (g^2 - c^2)/(g + c), so that an index near 1 loses nothing.
  const Real excess = (index - 1) * (index + 1);
  const Real g = sqrt(Real(excess + c * c));
  const Real sum = g + c;
  const Real difference = excess / sum;
  const Real normal_part = difference / sum;
  const Real ratio = (c * sum - 1) / (c * difference + 1);
  return normal_part * normal_part * (1 + ratio * ratio) / 2;
}

/// G / (N . V), G = min(1, 2 (N.H)(N.V)/(V.H), 2 (N.H)(N.L)/(V.H)).   [T] (1.4)
/// Term by term, so that the quotient stays finite and whole for a view that grazes the surface.
template <class Real>
Real shadowing(const Real& nh, const Real& vh, const Real& nl, const Real& nv) {
  using std::min;
  const Real slope = 2 * nh / vh;
  return min(Real(1 / nv), min(slope, Real(slope * nl / nv)));
}

/// R_s = F D G / (N . V) from the cosines of its angles.   [T] (1.4)
/// \param nh, vh, nl, nv  N.H, V.H, N.L, N.V, each in (0, 1]
template <class Real>
Real cook_torrance_of_cosines(facet_distribution distribution, const Real& m, const Real& index,
                              const Real& nh, const Real& vh, const Real& nl, const Real& nv) {
  return fresnel(vh, index) * facets(distribution, nh, m) * shadowing(nh, vh, nl, nv);
}

/// R_s = F D G / (N . V).   [T] (1.4)
/// \return  >= 0; 0 where light or view is behind the surface
template <class Real>
Real cook_torrance(facet_distribution distribution, const Real& m, const Real& index,
                   const vec3<Real>& normal, const vec3<Real>& light, const vec3<Real>& view) {
  if (!faces_both(normal, light, view)) return Real(0);
  const vec3<Real> half_vec = half_vector(light, view);
  const Real nh = clamped_cosine(normal, half_vec);
  const Real vh = clamped_cosine(view, half_vec);
  if (!(nh > 0 && vh > 0)) return Real(0);
  const Real nv = dot(normal, view);
  const Real nl = dot(normal, light);
  return cook_torrance_of_cosines(distribution, m, index, nh, vh, nl, nv);
}

/// R = s R_s + d R_d with d = 1 - s and, by Lambert's law, R_d = max(0, N . L).   [T] (1.3)
/// \param s  specular share, [0, 1]
template <class Real>
Real cook_torrance_mixed(const Real& s, facet_distribution distribution, const Real& m, const Real& index,
                         const vec3<Real>& normal, const vec3<Real>& light, const vec3<Real>& view) {
  return s * cook_torrance(distribution, m, index, normal, light, view) +
         (1 - s) * clamped_cosine(normal, light);
}

}  // namespace blysk::golden
