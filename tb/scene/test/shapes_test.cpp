// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>

#include "tb/catch.h"
#include "tb/scene/shapes.h"

namespace {

using namespace blysk::scene;
using blysk::golden::dot;

double volume_of(const mesh& of) {
  double sum = 0;
  for (const triangle& each : of.triangles) {
    const auto at = [&](std::size_t k) { return of.positions[each.position[k]]; };
    sum += dot(at(0), cross(at(1), at(2))) / 6;
  }
  return sum;
}

TEST_CASE("shapes are closed where they should be, and look outwards", "[scene]") {
  // Volumes of the sphere and the torus; the inscribed mesh has a little less.
  const double pi = M_PI;
  CHECK(volume_of(make_sphere(64)) == Approx(4 * pi / 3).epsilon(0.005));
  CHECK(volume_of(make_torus(64)) == Approx(2 * pi * pi * 0.4 * 0.4).epsilon(0.005));
  CHECK(volume_of(make_teapot(8)) > 0);
  CHECK(make_spheres(8).materials.size() == 16);
  for (const shape& each : shapes()) {
    CAPTURE(each.name);
    const mesh made = each.make(each.density);
    for (const vec& normal : made.normals) {
      if (std::abs(dot(normal, normal) - 1) > 1e-12) FAIL("a normal is no unit vector");
    }
    std::size_t inward = 0;
    for (const triangle& of : made.triangles) {
      const auto at = [&](std::size_t k) { return made.positions[of.position[k]]; };
      const vec area = cross(at(1) - at(0), at(2) - at(0));
      for (const std::uint32_t normal : of.normal) inward += dot(made.normals[normal], area) <= 0 ? 1U : 0U;
    }
    CHECK(inward == 0);
  }
}

TEST_CASE("the teapot is Newell's", "[scene]") {
  const mesh pot = make_teapot(10);
  // What Eric Haines gives for ten segments: 32 * 2 * n * n, less the triangles without area at the poles.
  CHECK(pot.triangles.size() == 6320);
  vec low{9, 9, 9};
  vec high{-9, -9, -9};
  for (const vec& at : pot.positions) {
    low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
  }
  CHECK(low.x == Approx(-3).margin(0.01));     // the handle
  CHECK(high.x == Approx(3.43).margin(0.01));  // the spout
  CHECK(low.y == Approx(0).margin(1e-12));
  CHECK(high.y == Approx(3.15));
  CHECK(low.z == Approx(-2).margin(1e-9));
  CHECK(high.z == Approx(2).margin(1e-9));
}

TEST_CASE("the fitted camera sees the whole mesh, of any size", "[scene]") {
  for (const double size : {1e-20, 1.0, 1e20}) {
    mesh made = make_torus(16);
    for (vec& each : made.positions) each = size * each + vec{3 * size, 0, 0};
    const camera view = fitted_camera(made);
    const vec forward = blysk::golden::normalised(view.target - view.eye);
    for (const vec& at : made.positions) {
      const vec to = blysk::golden::normalised(at - view.eye);
      REQUIRE(dot(to, forward) >= std::cos(view.fov_deg / 2 * M_PI / 180));
    }
  }
}

}  // namespace
