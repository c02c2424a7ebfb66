// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/sphere.h"

#include <algorithm>
#include <cmath>

namespace blysk::golden {

std::vector<sphere_pixel> sphere_pixels(const sphere_scene& scene) {
  std::vector<sphere_pixel> result;
  const auto coordinate = [&](int pixel) { return ((2 * pixel + 1.0) / scene.side - 1) / scene.radius; };
  for (int row = 0; row < scene.side; ++row) {
    for (int column = 0; column < scene.side; ++column) {
      const double x = coordinate(column);
      const double y = -coordinate(row);
      const double z2 = 1 - x * x - y * y;
      if (z2 > 0) result.push_back({column, row, {x, y, std::sqrt(z2)}});
    }
  }
  return result;
}

std::vector<double> shade_sphere(const sphere_scene& scene, const illumination<double>& i, lobe which,
                                 double n) {
  return with_lobe(which, n, [&](const auto& f) {
    std::vector<double> picture;
    for (const auto& [column, row, normal] : sphere_pixels(scene)) {
      picture.push_back(lambert(i, normal, scene.light) +
                        i.point_light * i.ks * highlight(f, normal, scene.light, scene.view));
    }
    return picture;
  });
}

double nmse(std::span<const double> reference, std::span<const double> picture) {
  double difference = 0;
  double energy = 0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    difference += (reference[i] - picture[i]) * (reference[i] - picture[i]);
    energy += reference[i] * reference[i];
  }
  return difference / energy;
}

}  // namespace blysk::golden
