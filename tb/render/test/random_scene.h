// SPDX-License-Identifier: Apache-2.0
/// Scenes for tests, made from a seed: every kind of material, light and camera that a rule of the plan looks at.
#pragma once

#include <random>

#include "tb/scene/scene.h"

namespace blysk::render::test {

class scene_maker {
 public:
  explicit scene_maker(std::uint64_t seed) : bits_(seed) {}

  std::size_t below(std::size_t end) { return static_cast<std::size_t>(bits_() % end); }
  double real(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(bits_() >> 11), -53);
  }

  scene::world make() {
    scene::world made;
    const std::size_t materials = 1 + below(4);
    for (std::size_t i = 0; i < materials; ++i) made.surface.materials.push_back(make_material());
    const std::size_t triangles = 1 + below(12);
    for (std::size_t i = 0; i < triangles; ++i)
      add_triangle(made.surface, static_cast<std::uint32_t>(below(materials)));
    made.lights.clear();
    const std::size_t lights = below(4);
    for (std::size_t i = 0; i < lights; ++i) made.lights.push_back(make_light(made.surface));
    made.ambient = make_colour();
    made.background = make_colour();
    if (below(2) == 0) {
      scene::camera view = scene::fitted_camera(made.surface);
      // Anywhere, also among the triangles.
      view.eye = view.eye + 2.0 * make_vector();
      made.view = view;
    }
    return made;
  }

 private:
  scene::vec make_vector() { return {real(-1, 1), real(-1, 1), real(-1, 1)}; }

  scene::rgb make_colour() {
    switch (below(4)) {
      case 0:
        return {0, 0, 0};
      case 1: {
        const double grey = real(0, 1);
        return {grey, grey, grey};
      }
      case 2:
        return {real(0, 1), 0, real(0, 0.01)};
      default:
        return {real(0, 1), real(0, 1), real(0, 1)};
    }
  }

  scene::material make_material() {
    static constexpr std::array kExponents{1, 2, 3, 4, 10, 50, 200, 1000};
    scene::material made;
    if (below(5) == 0) made.emitted = make_colour();
    made.ka = make_colour();
    made.kd = make_colour();
    made.ks = make_colour();
    made.n = kExponents[below(kExponents.size())];
    return made;
  }

  void add_triangle(scene::mesh& to, std::uint32_t material) {
    const auto first = static_cast<std::uint32_t>(to.positions.size());
    const auto first_normal = static_cast<std::uint32_t>(to.normals.size());
    for (int k = 0; k < 3; ++k) to.positions.push_back(make_vector());
    const scene::vec area = scene::cross(to.positions[first + 1] - to.positions[first],
                                         to.positions[first + 2] - to.positions[first]);
    for (int k = 0; k < 3; ++k)
      to.normals.push_back(golden::normalised(golden::normalised(area) + real(0, 0.8) * make_vector()));
    to.triangles.push_back(
        {{first, first + 1, first + 2}, {first_normal, first_normal + 1, first_normal + 2}, material});
  }

  scene::light make_light(const scene::mesh& surface) {
    scene::light made;
    made.colour = make_colour();
    made.is_point = below(2) == 0;
    made.at = made.is_point && below(4) == 0 ? surface.positions[below(surface.positions.size())]
                                             : 3.0 * make_vector();
    return made;
  }

  std::mt19937_64 bits_;
};

}  // namespace blysk::render::test
