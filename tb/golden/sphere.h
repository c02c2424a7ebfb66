// SPDX-License-Identifier: Apache-2.0
/// The test figure of [T] 3.4 without a renderer: a sphere seen orthographically under one distant light.
#pragma once

#include <span>
#include <vector>

#include "tb/golden/scene.h"

namespace blysk::golden {

/// View (0, 0, 1), light along (0.4, 0.5, 0.75), radius 0.9 of half the picture's side.
struct sphere_scene {
  int side = 512;  ///< pixels
  double radius = 0.9;
  vec3<double> view{0, 0, 1};
  vec3<double> light = normalised(vec3<double>{0.4, 0.5, 0.75});
};

/// A pixel that the sphere covers, and the normal at its centre.
struct sphere_pixel {
  int x, y;
  vec3<double> normal;
};

/// The pixels that the sphere covers, row by row from the top.
std::vector<sphere_pixel> sphere_pixels(const sphere_scene& scene);

/// Grey value of every such pixel, half_vector_shading; white light, so that R = G = B.
std::vector<double> shade_sphere(const sphere_scene& scene, const illumination<double>& i, lobe which,
                                 double n);

/// sum (a - b)^2 / sum a^2, a the reference picture.   [T] (3.1) for grey pictures
double nmse(std::span<const double> reference, std::span<const double> picture);

}  // namespace blysk::golden
