// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/turn.h"

#include <cmath>

namespace blysk::scene {

mesh turned(const mesh& of, const vec& through, const vec& axis, double angle_rad) {
  const vec k = golden::normalised(axis);
  const double cosine = std::cos(angle_rad);
  const double sine = std::sin(angle_rad);
  // Rodrigues' formula.
  const auto turn = [&](const vec& v) {
    return cosine * v + sine * cross(k, v) + ((1 - cosine) * golden::dot(k, v)) * k;
  };
  mesh made = of;
  for (vec& each : made.positions) each = through + turn(each - through);
  for (vec& each : made.normals) each = golden::normalised(turn(each));
  return made;
}

}  // namespace blysk::scene
