// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blysk::scene {

camera fitted_camera(const mesh& surface) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  vec low{kInfinity, kInfinity, kInfinity};
  vec high{-kInfinity, -kInfinity, -kInfinity};
  for (const triangle& each : surface.triangles) {
    for (const std::uint32_t corner : each.position) {
      const vec& at = surface.positions[corner];
      low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
    }
  }
  camera view;
  view.target = 0.5 * (low + high);
  double radius2 = 0;
  for (const triangle& each : surface.triangles) {
    for (const std::uint32_t corner : each.position) {
      const vec from_middle = surface.positions[corner] - view.target;
      radius2 = std::max(radius2, golden::dot(from_middle, from_middle));
    }
  }
  // The sphere around the mesh fills nine tenths of the shorter side.
  const double half_angle = view.fov_deg / 2 * golden::pi<double>() / 180;
  const double distance = std::sqrt(radius2) / std::sin(std::atan(0.9 * std::tan(half_angle)));
  view.eye = view.target + distance * golden::normalised(vec{0, 0.3, 1});
  return view;
}

}  // namespace blysk::scene
