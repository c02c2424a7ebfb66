// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/golden/scene.h"
#include "tb/render/points.h"

namespace blysk::render {

/// How a light meets a point.
struct incidence {
  vec light;            ///< unit vector towards it
  double nl = 0;        ///< N.L, [0, 1]
  bool is_lit = false;  ///< light and eye are on the side that the normal points to
};

/// Lights with their directions of length 1.
inline std::vector<scene::light> with_unit_directions(std::vector<scene::light> lights) {
  for (scene::light& each : lights) {
    if (!each.is_point) each.at = golden::normalised(each.at);
  }
  return lights;
}

/// \param view   unit vector from the point to the eye
/// \param light  with a direction of length 1, if it is far away
inline incidence incidence_of(const point& at, const vec& view, const scene::light& light) {
  const vec to_light = light.is_point ? golden::normalised(light.at - at.position) : light.at;
  return {to_light, golden::clamped_cosine(at.normal, to_light),
          golden::faces_both(at.normal, to_light, view)};
}

/// N.H, [0, 1], where the light falls on the side that is seen; else 0. H = (L + V) / |L + V|.
inline double half_cosine(const point& at, const vec& view, const incidence& met) {
  return met.is_lit ? golden::clamped_cosine(at.normal, golden::half_vector(met.light, view)) : 0;
}

/// False only if N.H < cosine: N.(L + V) against |L + V|, without a root and a division.
inline bool may_reach(const point& at, const vec& view, const incidence& met, double cosine) {
  const vec sum = met.light + view;
  const double along = golden::dot(at.normal, sum);
  return along * along >= cosine * cosine * golden::dot(sum, sum);
}

}  // namespace blysk::render
