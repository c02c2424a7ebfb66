// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tb/golden/teapot_patches.h"
#include "tb/scene/material.h"

namespace blysk::scene {
namespace {

/// Place and normal of a surface at (u, v).
struct surface_point {
  vec position, normal;
};

/// Appends a grid of columns x rows quadrangles over (u, v) in [0, 1] x [0, 1]. du x dv points outwards. Triangles of no
/// area, at poles, are left out.
template <class Surface>
void append_grid(mesh& to, int columns, int rows, std::uint32_t material, const Surface& surface) {
  const auto first = static_cast<std::uint32_t>(to.positions.size());
  const auto first_normal = static_cast<std::uint32_t>(to.normals.size());
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const surface_point at =
          surface(static_cast<double>(column) / columns, static_cast<double>(row) / rows);
      to.positions.push_back(at.position);
      to.normals.push_back(at.normal);
    }
  }
  const auto append = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const vec& origin = to.positions[first + a];
    const vec area = cross(to.positions[first + b] - origin, to.positions[first + c] - origin);
    if (golden::dot(area, area) < 1e-24) return;
    to.triangles.push_back({{first + a, first + b, first + c},
                            {first_normal + a, first_normal + b, first_normal + c},
                            material});
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto a = static_cast<std::uint32_t>(row * (columns + 1) + column);
      const std::uint32_t b = a + 1;
      const std::uint32_t c = a + static_cast<std::uint32_t>(columns) + 1;
      append(a, b, c);
      append(b, c + 1, c);
    }
  }
}

void append_sphere(mesh& to, int density, const vec& centre, double radius, std::uint32_t material) {
  append_grid(to, 2 * density, density, material, [&](double u, double v) {
    const double azimuth = 2 * golden::pi<double>() * u;
    const double polar = golden::pi<double>() * (1 - v);
    const double ring = v == 0 || v == 1 ? 0 : std::sin(polar);  // the poles are points
    const vec normal{ring * std::sin(azimuth), std::cos(polar), ring * std::cos(azimuth)};
    return surface_point{centre + radius * normal, normal};
  });
}

/// Bernstein polynomials of degree 3 at t, and their derivatives.
struct bernstein {
  explicit bernstein(double t) {
    const double s = 1 - t;
    value = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    slope = {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t};
  }
  std::array<double, 4> value, slope;
};

vec sum_of(const std::array<std::uint16_t, 16>& patch, const std::array<double, 4>& rows,
           const std::array<double, 4>& columns) {
  vec sum{0, 0, 0};
  for (std::size_t i = 0; i < patch.size(); ++i) {
    const auto& point = golden::kTeapotPoints[patch[i]];
    sum = sum + rows[i / 4] * columns[i % 4] * vec{point[0], point[2], -point[1]};  // y upward
  }
  return sum;
}

/// The patch at (u, v). Its normal at a pole, where a derivative vanishes, is that of the place beside it.
surface_point at_patch(const std::array<std::uint16_t, 16>& patch, double u, double v) {
  const auto normal_at = [&](double column, double row) {
    const bernstein along(column);
    const bernstein down(row);
    return cross(sum_of(patch, down.value, along.slope), sum_of(patch, down.slope, along.value));
  };
  vec normal = normal_at(u, v);
  if (golden::dot(normal, normal) < 1e-12) {
    constexpr double kBeside = 1e-4;
    normal = normal_at(std::clamp(u, kBeside, 1 - kBeside), std::clamp(v, kBeside, 1 - kBeside));
    normal = {0, normal.y, 0};  // the poles lie on the axis
  }
  return {sum_of(patch, bernstein(v).value, bernstein(u).value), golden::normalised(normal)};
}

}  // namespace

mesh make_sphere(int density) {
  mesh made;
  made.materials = {plain_material()};
  append_sphere(made, density, {0, 0, 0}, 1, 0);
  return made;
}

mesh make_teapot(int density) {
  mesh made;
  made.materials = {plain_material()};
  // Patches 20..27 and 28..31 have poles, and run the other way from those of rim, body, handle and spout or not: what
  // is outside follows from the normals, which append_grid() takes as they come.
  for (const auto& patch : golden::kTeapotPatches)
    append_grid(made, density, density, 0, [&](double u, double v) { return at_patch(patch, u, v); });
  return made;
}

mesh make_torus(int density) {
  constexpr double kRing = 1;
  constexpr double kTube = 0.4;
  mesh made;
  made.materials = {plain_material()};
  append_grid(made, 2 * density, density, 0, [&](double u, double v) {
    const double around = 2 * golden::pi<double>() * u;
    const double along = 2 * golden::pi<double>() * v;
    const vec outward{std::sin(around), 0, std::cos(around)};
    const vec normal = std::cos(along) * outward + vec{0, std::sin(along), 0};
    return surface_point{kRing * outward + kTube * normal, normal};
  });
  return made;
}

mesh make_spheres(int density) {
  constexpr std::array kExponents{1, 2, 3, 5, 8, 13, 20, 30, 50, 80, 120, 200, 300, 500, 700, 1000};
  constexpr std::array<rgb, 4> kColours{
      {{0.6, 0.2, 0.15}, {0.55, 0.45, 0.1}, {0.15, 0.5, 0.25}, {0.15, 0.25, 0.6}}};
  mesh made;
  for (std::size_t i = 0; i < kExponents.size(); ++i) {
    material each = plain_material();
    each.name = fmt::format("n{}", kExponents[i]);
    each.n = kExponents[i];
    each.ka = each.kd = kColours[i / 4];
    made.materials.push_back(each);
    const auto column = static_cast<double>(i % 4);
    const std::size_t in_rows = i / 4;
    const auto row = static_cast<double>(in_rows);
    append_sphere(made, density, {2.2 * (column - 1.5), 2.2 * (1.5 - row), 0}, 1,
                  static_cast<std::uint32_t>(i));
  }
  return made;
}

const std::vector<shape>& shapes() {
  static const std::vector<shape> all{
      {"sphere", "of radius 1", 64, make_sphere},
      {"teapot", "Newell's, 32 Bezier patches", 16, make_teapot},
      {"torus", "radii 1 and 0.4", 64, make_torus},
      {"spheres", "sixteen, n from 1 to 1000", 32, make_spheres},
  };
  return all;
}

const shape* find_shape(std::string_view name) {
  const auto found = std::ranges::find(shapes(), name, &shape::name);
  return found == shapes().end() ? nullptr : &*found;
}

}  // namespace blysk::scene
