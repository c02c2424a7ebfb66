// SPDX-License-Identifier: Apache-2.0
/// Shapes that need no file.
#pragma once

#include <string_view>
#include <vector>

#include "tb/scene/scene.h"

namespace blysk::scene {

struct shape {
  std::string_view name;
  std::string_view help;
  int density;  ///< preset
  mesh (*make)(int density);
};

/// sphere, teapot, torus, spheres.
const std::vector<shape>& shapes();

/// nullptr if there is none of that name
const shape* find_shape(std::string_view name);

/// With less a sphere has no area.
inline constexpr int kLeastDensity = 2;
inline constexpr int kMostDensity = 1000;

/// Radius 1: `density` rings of twice as many quadrangles.
mesh make_sphere(int density);

/// The 32 patches of tb/golden/teapot_patches.h, each cut into density x density quadrangles, y upward, the base at 0.
mesh make_teapot(int density);

/// Around the y axis, radii 1 and 0.4: 2 density x density quadrangles.
mesh make_torus(int density);

/// Sixteen spheres, exponents 1 to 1000 from left to right and from above, a colour in each row.
mesh make_spheres(int density);

}  // namespace blysk::scene
