// SPDX-License-Identifier: Apache-2.0
/// Quadratic interpolation in a triangle.   [T] listing A, Quadratic_Interpolation
#pragma once

#include <array>
#include <stdexcept>

namespace blysk::golden {

/// A triangle in the plane of the picture, its first vertex at the origin; pixels.
template <class Real>
struct triangle {
  Real x2, y2, x3, y3;
};

/// Intensities at the vertices and at the middles of the edges, one channel.
template <class Real>
struct six_intensities {
  Real i1, i2, i3, i12, i13, i23;
};

/// I(x, y) = p5 x^2 + p4 x y + p3 y^2 + p2 x + p1 y + p0, numbered as in the listing.
template <class Real>
struct quadratic_surface {
  Real p0, p1, p2, p3, p4, p5;

  Real at(const Real& x, const Real& y) const {
    return p5 * x * x + p4 * x * y + p3 * y * y + p2 * x + p1 * y + p0;
  }

  /// Along a scan line the second difference is the same everywhere; the first one is that from x to x + 1.
  Real first_difference(const Real& x, const Real& y) const { return p5 * (2 * x + 1) + p4 * y + p2; }
  Real second_difference() const { return 2 * p5; }
};

/// The polynomial of the second degree through the six intensities, the only one. With s2 and s3 the barycentric coordinates
/// of vertices 2 and 3, s2 = (x y3 - y x3)/D and s3 = (y x2 - x y2)/D, D = x2 y3 - y2 x3, it is
///   i1 + c2 s2 + c3 s3 + 2 c12 s2^2 + c23 s2 s3 + 2 c13 s3^2
/// where the c are those of the listing.
/// \throws std::domain_error for a triangle without area
template <class Real>
quadratic_surface<Real> surface_through(const triangle<Real>& of, const six_intensities<Real>& in) {
  const Real area = of.x2 * of.y3 - of.y2 * of.x3;  // twice the triangle's, with a sign
  if (area == 0) throw std::domain_error("the triangle has no area");
  const Real c2 = 4 * in.i12 - 3 * in.i1 - in.i2;
  const Real c3 = 4 * in.i13 - 3 * in.i1 - in.i3;
  const Real c12 = in.i1 + in.i2 - 2 * in.i12;
  const Real c13 = in.i1 + in.i3 - 2 * in.i13;
  const Real c23 = 4 * (in.i1 - in.i12 - in.i13 + in.i23);
  const Real square = area * area;
  return {
      in.i1,
      (c3 * of.x2 - c2 * of.x3) / area,
      (c2 * of.y3 - c3 * of.y2) / area,
      (2 * c12 * of.x3 * of.x3 - c23 * of.x2 * of.x3 + 2 * c13 * of.x2 * of.x2) / square,
      (c23 * (of.x2 * of.y3 + of.x3 * of.y2) - 4 * c12 * of.x3 * of.y3 - 4 * c13 * of.x2 * of.y2) / square,
      (2 * c12 * of.y3 * of.y3 - c23 * of.y2 * of.y3 + 2 * c13 * of.y2 * of.y2) / square};
}

/// What the listing prints otherwise (E19); each can be taken over alone.
struct listing_slips {
  bool term = false;      ///< lines 322, 341, 360: P4 has 4 C12 where P5 has 4 C12 Y3
  bool division = false;  ///< lines 327, 346, 365: / Y2 * Y2, which divides and multiplies
  bool blue = false;      ///< line 358: C23 of blue has - 4 I23, that of red and green + 4 I23
};

/// The listing's own steps, lines 312 to 327, in double: P3 is not finite where Y2, which it divides by, is 0.
inline quadratic_surface<double> surface_of_listing(const triangle<double>& of,
                                                    const six_intensities<double>& in,
                                                    const listing_slips& slips) {
  const auto [x2, y2, x3, y3] = of;
  const double c2 = 4 * in.i12 - 3 * in.i1 - in.i2;
  const double c12 = in.i1 + in.i2 - 2 * in.i12;
  const double c3 = 4 * in.i13 - 3 * in.i1 - in.i3;
  const double c13 = in.i1 + in.i3 - 2 * in.i13;
  const double c23 = 4 * in.i1 - 4 * in.i12 - 4 * in.i13 + (slips.blue ? -4 : 4) * in.i23;
  const double d23 = 2 * x2 * x2 * y3 - 2 * x2 * y2 * x3;
  const double d32 = 2 * y2 * x3 * x3 - 2 * x2 * x3 * y3;
  const double e23 = x2 * y2 * y3 - y2 * y2 * x3;
  const double e32 = y2 * x3 * y3 - x2 * y3 * y3;
  const double below = e32 * d23 - e23 * d32;
  const double of_12 = 4 * c12 * y3 - c23 * y2;
  const double of_13 = 4 * c13 * y2 - c23 * y3;
  const double p4 = (of_13 * d23 - (slips.term ? 4 * c12 - c23 * y2 : of_12) * d32) / below;
  const double p5 = (of_12 * e32 - of_13 * e23) / below;
  const double rest = 2 * c12 - p5 * x2 * x2 - p4 * x2 * y2;
  return {in.i1,
          (c3 * x2 - c2 * x3) / (x2 * y3 - y2 * x3),
          (c2 * y3 - c3 * y2) / (x2 * y3 - y2 * x3),
          slips.division ? rest / y2 * y2 : rest / (y2 * y2),
          p4,
          p5};
}

}  // namespace blysk::golden
