// SPDX-License-Identifier: Apache-2.0
/// A scene as data: triangles, materials, lights, camera. Readers and built-in shapes make it, a renderer reads it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tb/golden/scene.h"

namespace blysk::scene {

using vec = golden::vec3<double>;
using rgb = std::array<double, 3>;  ///< red, green, blue, each in [0, 1]

/// a x b
inline vec cross(const vec& a, const vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// What a surface does with light. Legal: shares in [0, 1], n in 1..1000; make_legal() of material.h sees to it.
struct material {
  std::string name;
  rgb emitted{0, 0, 0};  ///< colour that needs no light
  rgb ka{0, 0, 0};       ///< ambient share
  rgb kd{0, 0, 0};       ///< diffuse share
  rgb ks{0, 0, 0};       ///< specular share
  int n = 1;             ///< specular exponent
};

/// Counter-clockwise as seen from outside.
struct triangle {
  std::array<std::uint32_t, 3> position;  ///< of mesh::positions
  std::array<std::uint32_t, 3> normal;    ///< of mesh::normals
  std::uint32_t material;
};

struct mesh {
  std::vector<vec> positions;  ///< finite, at most kLargest
  std::vector<vec> normals;    ///< unit vectors, outward
  std::vector<triangle> triangles;
  std::vector<material> materials;

  /// Products of three coordinates, and of three such products, stay finite.
  static constexpr double kLargest = 1e30;

  /// Of a mesh's extent: products of three lengths stay normal numbers.
  static constexpr double kSmallest = 1e-100;
};

inline constexpr std::size_t kMostLights = 64;  ///< that a renderer takes

struct light {
  bool is_point = false;   ///< at a place; else far away
  vec at{0.4, 0.5, 0.75};  ///< its place, or the direction towards it, of any length above 0
  rgb colour{1, 1, 1};
};

struct camera {
  vec eye, target;
  vec up{0, 1, 0};
  double fov_deg = 30;  ///< angle over the shorter side of the picture
};

/// What a renderer needs besides the device.
struct world {
  mesh surface;
  std::vector<light> lights{light{}};
  rgb ambient{0.2, 0.2, 0.2};  ///< light from everywhere
  rgb background{0, 0, 0};
  std::optional<camera> view;         ///< none: the whole mesh, seen from the front and a little from above
  std::vector<std::string> messages;  ///< what a reader changed or dropped, a line each
};

/// The camera that shows the whole mesh.
camera fitted_camera(const mesh& surface);

}  // namespace blysk::scene
