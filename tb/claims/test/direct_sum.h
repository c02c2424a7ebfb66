// SPDX-License-Identifier: Apache-2.0
/// Directional-hemispherical reflectance by a plain sum, vector by vector.
#pragma once

#include <algorithm>
#include <cmath>

namespace blysk::claims::literal {

/// R = integral of f(N.H) (N.O) d omega_O over the outgoing rays O above the surface, by half vectors H in `steps` x
/// `steps` cells around the normal: O is L mirrored at H, and d omega_O = 4 (O.H) d omega_H.
/// Midpoint rule: the error falls with the square of the cells' width.
/// \param f       of the cosine
/// \param end     angle at which the lobe ends, rad
/// \param degrees incidence
template <class F>
double direct_sum(const F& f, double end, double degrees, int steps) {
  const double pi = std::acos(-1.0);
  const double incidence = degrees * pi / 180;
  const double lx = std::sin(incidence);
  const double lz = std::cos(incidence);
  const double reach = std::min(end, pi / 2);
  double result = 0;
  for (int i = 0; i < steps; ++i) {
    const double alpha = reach * (i + 0.5) / steps;
    const double value = f(std::cos(alpha)) * std::sin(alpha);
    for (int j = 0; j < steps; ++j) {
      const double phi = pi * (j + 0.5) / steps;  // the other half is alike
      const double hx = std::sin(alpha) * std::cos(phi);
      const double hz = std::cos(alpha);
      const double lh = lx * hx + lz * hz;
      const double oz = 2 * lh * hz - lz;
      if (oz > 0 && lh > 0) result += value * oz * 4 * lh;
    }
  }
  return 2 * result * (reach / steps) * (pi / steps);
}

}  // namespace blysk::claims::literal
