// SPDX-License-Identifier: Apache-2.0
// What each pixel sees, against rays that are cut with the triangles.
#include <algorithm>
#include <cmath>
#include <random>

#include "tb/catch.h"
#include "tb/render/visibility.h"
#include "tb/scene/shapes.h"

namespace {

using namespace blysk;
using namespace blysk::render;
using scene::vec;

/// The ray through the middle of a pixel: a point of it at distance 1 along the view.
vec ray_of(const scene::camera& view, int width, int height, double x, double y) {
  const vec forward = golden::normalised(view.target - view.eye);
  const vec right = golden::normalised(scene::cross(forward, view.up));
  const vec up = scene::cross(right, forward);
  const double pixel = 2 * std::tan(view.fov_deg / 2 * M_PI / 180) / std::min(width, height);
  return forward + pixel * (x + 0.5 - width / 2.0) * right - pixel * (y + 0.5 - height / 2.0) * up;
}

/// Distance along the ray to the triangle (Moeller, Trumbore 1997), 0 if it misses; how near to an edge, in shares.
struct hit {
  double distance, edge;
};
hit cut(const scene::mesh& of, std::uint32_t triangle, const vec& eye, const vec& ray) {
  const auto at = [&](std::size_t k) { return of.positions[of.triangles[triangle].position[k]]; };
  const vec a = at(1) - at(0);
  const vec b = at(2) - at(0);
  const vec p = scene::cross(ray, b);
  const double determinant = golden::dot(a, p);
  const vec s = eye - at(0);
  const double u = golden::dot(s, p) / determinant;
  const vec q = scene::cross(s, a);
  const double v = golden::dot(ray, q) / determinant;
  const double t = golden::dot(b, q) / determinant;
  const double edge = std::min({u, v, 1 - u - v});
  return {edge >= 0 && t > 0 ? t : 0, std::abs(edge)};
}

scene::mesh random_triangles(std::mt19937_64& bits, std::size_t count) {
  std::uniform_real_distribution<double> any(-1, 1);
  scene::mesh made;
  made.materials.resize(1);
  made.normals.push_back({0, 0, 1});
  for (std::uint32_t i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) made.positions.push_back({any(bits), any(bits), any(bits)});
    made.triangles.push_back({{3 * i, 3 * i + 1, 3 * i + 2}, {0, 0, 0}, 0});
  }
  return made;
}

TEST_CASE("every pixel sees the triangle that its ray meets first, also from within the mesh", "[render]") {
  std::mt19937_64 bits(1);
  std::uniform_real_distribution<double> any(-1, 1);
  constexpr int kWidth = 40;
  constexpr int kHeight = 30;
  std::size_t compared = 0;
  for (int scene_number = 0; scene_number < 60; ++scene_number) {
    const scene::mesh of = random_triangles(bits, 30);
    scene::camera view;
    view.eye = {any(bits), any(bits), scene_number % 2 == 0 ? 4 : any(bits)};
    view.target = {0.1 * any(bits), 0.1 * any(bits), 0.1 * any(bits)};
    view.fov_deg = 40 + 40 * any(bits);
    const visibility seen = find_visible(of, projection(view, kWidth, kHeight), kWidth, kHeight, 2);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const vec ray = ray_of(view, kWidth, kHeight, x, y);
        std::uint32_t first = kNoTriangle;
        double nearest = 0;
        bool is_clear = true;  // no edge and no second surface within the roundings of both computations
        for (std::uint32_t i = 0; i < of.triangles.size(); ++i) {
          const hit met = cut(of, i, view.eye, ray);
          is_clear = is_clear && met.edge > 1e-9;
          if (met.distance == 0) continue;
          is_clear = is_clear && std::abs(met.distance - nearest) > 1e-9 * nearest;
          if (first == kNoTriangle || met.distance < nearest) {
            first = i;
            nearest = met.distance;
          }
        }
        if (!is_clear) continue;
        ++compared;
        if (seen.triangle[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)] != first)
          FAIL("pixel " << x << ", " << y << " of scene " << scene_number);
      }
    }
  }
  CHECK(compared > 60 * kWidth * kHeight * 99 / 100);
}

TEST_CASE("triangles that share edges cover each pixel once", "[render]") {
  // A fan around the middle of a pixel. With coordinates in quarters all sums are exact, spokes run through centres of
  // pixels, and every tie occurs. With any coordinates neighbours round the edge they share alike; the corner they all
  // share, where each edge is rounded by itself, is left out.
  std::mt19937_64 bits(2);
  for (const bool is_exact : {true, false}) {
    for (const int spokes : {3, 4, 8, 16, 61}) {
      std::vector<vec> rim;
      for (int i = 0; i < spokes; ++i) {
        const auto along = [&](double share) {
          return is_exact ? std::round(4 * 90 * share) / 4 : 90 * share;
        };
        rim.push_back({16.5 + along(std::cos(2 * M_PI * i / spokes)),
                       16.5 + along(std::sin(2 * M_PI * i / spokes)), 1});
      }
      std::vector<footprint> fan;
      for (std::size_t i = 0; i < rim.size(); ++i) {
        std::array<vec, 3> corners{vec{16.5, 16.5, 1}, rim[i], rim[(i + 1) % rim.size()]};
        std::ranges::shuffle(corners, bits);  // of either winding, from any corner on
        fan.emplace_back(std::array<vec, 3>{3.0 * corners[0], 3.0 * corners[1], 3.0 * corners[2]});
      }
      for (int y = 0; y < 33; ++y) {
        for (int x = 0; x < 33; ++x) {
          if (!is_exact && x == 16 && y == 16) continue;
          footprint::weights sides{};
          const auto covering = std::ranges::count_if(
              fan, [&](const footprint& each) { return each.covers(x + 0.5, y + 0.5, sides); });
          CAPTURE(is_exact, spokes, x, y);
          REQUIRE(covering == 1);
        }
      }
    }
  }
}

TEST_CASE("shares of corners give the point on the surface, or on the picture", "[render]") {
  scene::camera view;
  view.eye = {0, 0, 5};
  view.target = {0, 0, 0};
  const projection onto(view, 100, 100);
  const std::array<vec, 3> corners{vec{-1, -1, 2}, vec{1, -1, -3}, vec{0, 1, 0}};
  const footprint print({onto.of(corners[0]), onto.of(corners[1]), onto.of(corners[2])});
  REQUIRE(print.has_area());
  CHECK(print.is_front());
  for (const auto& [x, y] : {std::pair{50.0, 50.0}, {45.5, 60.5}, {52.25, 48.0}}) {
    const auto on_surface = print.shares(x, y, true);
    const vec point = on_surface[0] * corners[0] + on_surface[1] * corners[1] + on_surface[2] * corners[2];
    const vec seen = onto.of(point);
    CHECK(seen.x / seen.z == Approx(x));
    CHECK(seen.y / seen.z == Approx(y));
    const auto on_picture = print.shares(x, y, false);
    double sum_x = 0;
    double sum_y = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const vec at = onto.of(corners[k]);
      sum_x += on_picture[k] * at.x / at.z;
      sum_y += on_picture[k] * at.y / at.z;
    }
    CHECK(sum_x == Approx(x));
    CHECK(sum_y == Approx(y));
  }
  const footprint back({onto.of(corners[0]), onto.of(corners[2]), onto.of(corners[1])});
  CHECK(!back.is_front());
  CHECK(back.has_area());
}

TEST_CASE("threads see the same", "[render]") {
  const scene::mesh of = scene::make_teapot(8);
  const projection view(scene::fitted_camera(of), 150, 101);
  const visibility one = find_visible(of, view, 150, 101, 1);
  CHECK(find_visible(of, view, 150, 101, 5).triangle == one.triangle);
  CHECK(std::ranges::count_if(one.triangle, [](std::uint32_t each) { return each != kNoTriangle; }) > 1000);
}

}  // namespace
