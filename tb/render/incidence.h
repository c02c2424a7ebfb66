// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/golden/scene.h"
#include "tb/render/points.h"

namespace blysk::render {

/// How a light meets a point.
struct incidence {
  double nl = 0;        ///< N.L, [0, 1]
  double nh = 0;        ///< N.H, [0, 1]; H = (L + V) / |L + V|
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
  incidence made;
  made.nl = golden::clamped_cosine(at.normal, to_light);
  made.is_lit = golden::faces_both(at.normal, to_light, view);
  if (made.is_lit) made.nh = golden::clamped_cosine(at.normal, golden::half_vector(to_light, view));
  return made;
}

}  // namespace blysk::render
