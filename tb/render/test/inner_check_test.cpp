// SPDX-License-Identifier: Apache-2.0
// The inner specular check never leaves out a pixel of a highlight, and leaves out most of the others.
#include "tb/render/inner_check.h"

#include <algorithm>
#include <cmath>

#include "tb/catch.h"
#include "tb/render/incidence.h"
#include "tb/render/points.h"
#include "tb/render/test/picture_source.h"
#include "tb/render/test/random_scene.h"
#include "tb/scene/shapes.h"

namespace {

using namespace blysk;
using namespace blysk::render;

constexpr double kRoundings = 3e-7;  // what inner_check.cpp derives
static_assert(kRoundings < highlight_bound::kMargin);

scene::vec random_vector(test::scene_maker& from, double length) {
  return length * scene::vec{from.real(-1, 1), from.real(-1, 1), from.real(-1, 1)};
}

/// A scene of scene_maker, in every second case with other triangles: small ones, bent ones, ones with opposite normals,
/// far from the origin.
scene::world random_world(test::scene_maker& from, bool is_own) {
  scene::world made = from.make();
  if (!is_own) return made;
  const scene::vec place = random_vector(from, std::pow(10, from.real(-1, 6)));
  const double size = std::pow(10, from.real(-3, 0.3));
  const double bend = std::pow(10, from.real(-3, 0.5));
  for (const scene::triangle& each : made.surface.triangles) {
    const scene::vec middle = random_vector(from, 0.3);
    const scene::vec normal = golden::normalised(random_vector(from, 1));
    for (std::size_t k = 0; k < 3; ++k) {
      made.surface.positions[each.position[k]] = place + middle + random_vector(from, size);
      made.surface.normals[each.normal[k]] = golden::normalised(normal + random_vector(from, bend));
    }
  }
  for (scene::light& each : made.lights) {
    if (each.is_point) each.at = place + random_vector(from, 2);
  }
  scene::camera view;
  view.target = place;
  view.eye = place + random_vector(from, 1.5);
  view.fov_deg = from.real(5, 120);
  made.view = view;
  return made;
}

/// Triangles with the first corner a little behind the eye, the others before it: directions that a cone holds.
scene::world world_beside_the_eye(test::scene_maker& from) {
  scene::world made = from.make();
  for (const scene::triangle& each : made.surface.triangles) {
    const scene::vec normal = golden::normalised(scene::vec{-1, 0, 0.5} + random_vector(from, 0.5));
    for (std::size_t k = 0; k < 3; ++k) {
      const double angle = k == 0 ? from.real(1.58, 1.8) : from.real(0.7, 1.2);
      const double turn = from.real(-0.4, 0.4);
      const scene::vec towards{std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn),
                               -std::cos(angle)};
      made.surface.positions[each.position[k]] = from.real(0.5, 2) * towards;
      made.surface.normals[each.normal[k]] = golden::normalised(normal + random_vector(from, 0.5));
    }
  }
  scene::camera view;
  view.eye = {0, 0, 0};
  view.target = {0, 0, -1};
  view.fov_deg = 150;
  made.view = view;
  return made;
}

struct tally {
  std::size_t pixels = 0;
  std::size_t bounded = 0;
  double slack = 0;  // of the bound over the largest N.H of a triangle, where there is a bound
  std::size_t triangles = 0;
};

/// Holds the bound of every triangle against every pixel of it, under every light.
void hold(const scene::world& of, bool corrected, tally& to) {
  constexpr int kSide = 24;
  const projection view(of.view ? *of.view : scene::fitted_camera(of.surface), kSide, kSide);
  const visibility seen = find_visible(of.surface, view, kSide, kSide, 1);
  const auto points = find_shading("phong").make(of.surface, view, seen, corrected);
  const std::vector<scene::light> lights = with_unit_directions(of.lights);
  for (std::uint32_t triangle = 0; triangle < of.surface.triangles.size(); ++triangle) {
    const highlight_bound bound(of.surface, view, triangle, corrected);
    for (const scene::light& light : lights) {
      const double most = bound.most_half_cosine(light);
      double largest = -1;
      point_source::cursor near;
      for (std::size_t pixel = 0; pixel < seen.pixels(); ++pixel) {
        if (seen.triangle[pixel] != triangle) continue;
        point at;
        REQUIRE(points->at(pixel, near, at));
        const scene::vec towards_eye = golden::normalised(view.eye() - at.position);
        const incidence met = incidence_of(at, towards_eye, light);
        const double half = golden::dot(at.normal, golden::half_vector(met.light, towards_eye));
        largest = std::max(largest, half);
        ++to.pixels;
        to.bounded += most < 1 ? 1 : 0;
        if (!(half <= most + kRoundings)) {
          CAPTURE(triangle, pixel, corrected, half, most);
          FAIL("a pixel above the bound");
        }
      }
      if (largest < 0 || most == 1) continue;
      to.slack += most - largest;
      ++to.triangles;
    }
  }
}

void hold_random(std::uint64_t first_seed, std::uint64_t count) {
  tally all;
  for (std::uint64_t seed = first_seed; seed < first_seed + count; ++seed) {
    CAPTURE(seed);
    test::scene_maker maker(seed);
    const scene::world of = random_world(maker, seed % 4 != 0);
    hold(of, seed % 3 != 0, all);
    hold(world_beside_the_eye(maker), seed % 2 == 0, all);
  }
  CAPTURE(all.pixels, all.bounded, all.triangles, all.slack);
  CHECK(all.pixels > 50 * count);
  CHECK(all.bounded > all.pixels / 4);
  CHECK(all.triangles > count);
  CHECK(all.slack < 0.3 * static_cast<double>(all.triangles));
}

TEST_CASE("no pixel of a random triangle is above its bound", "[render]") {
  hold_random(1, 3000);
}

TEST_CASE("no pixel of very many random triangles is above its bound", "[render][full]") {
  hold_random(100'000, 60'000);
}

/// A triangle of equal normals, far from the eye: N.H is the same everywhere.
scene::world plane_of(double half_cosine, const scene::material& material) {
  scene::world made;
  made.surface.positions = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0, 0.5, 0}};
  made.surface.materials = {material};
  made.surface.triangles = {{{0, 1, 2}, {0, 0, 0}, 0}};
  scene::camera view;
  view.eye = {0, 0, 1e5};
  view.fov_deg = 1.1e-5 * 180 / M_PI;
  made.view = view;
  made.lights = {{false, {0.6, 0, 0.8}, {1, 1, 1}}};
  const scene::vec half = golden::normalised(scene::vec{0.6, 0, 1.8});
  made.surface.normals = {half_cosine * half +
                          std::sqrt(1 - half_cosine * half_cosine) * scene::vec{0, 1, 0}};
  return made;
}

TEST_CASE("a triangle is left out up to one code below the lobe and no further", "[render]") {
  for (const char* format : {"q8", "q12"}) {
    const test::picture_source from(choose(devices().front()->name(), format), false);
    for (const int n : {10, 50, 1000}) {
      const scene::material material{.name = "", .ka = {}, .kd = {0.2, 0.2, 0.2}, .ks = {1, 1, 1}, .n = n};
      const double code = std::ldexp(1.0, -device_ports(from.of()->device).cos_fraction());
      job asked{
          .of = nullptr, .width = 10, .height = 10, .shading = &find_shading("phong"), .device = from.of()};
      const auto picture = [&](double half_cosine, effects effects) {
        const scene::world of = plane_of(half_cosine, material);
        asked.of = &of;
        asked.asked = effects;
        return render::render(asked);
      };
      const plan planned = picture(0.5, effects::automatic).planned;
      const double begin = static_cast<double>(planned.at(0, 0).lobe_begin) * code;
      for (double steps = -4; steps <= 1; steps += 0.125) {
        const double half_cosine = begin + steps * code;
        if (half_cosine > 1) break;
        const outcome few = picture(half_cosine, effects::automatic);
        const outcome all = picture(half_cosine, effects::all);
        CAPTURE(format, n, steps, half_cosine);
        REQUIRE(few.pixels > 35);
        REQUIRE(few.image.rgb == all.image.rgb);
        // Between codes, and one code below the lobe, the roundings decide.
        if (std::abs(steps + 0.5) < 0.1 || std::abs(steps + 1) < 0.1) continue;
        REQUIRE(few.device_writes == (steps > -0.5 ? few.pixels : 0));
        REQUIRE(few.tests_left_out == (steps < -1 ? few.pixels : 0));
        REQUIRE(few.triangles_left_out == (steps < -1 ? 1 : 0));
      }
    }
  }
}

TEST_CASE("most triangles of a sphere are left out, and the picture stays", "[render]") {
  scene::world of;
  of.surface = scene::make_sphere(12);
  of.lights.push_back({true, {2, 1, 3}, {0.5, 0, 0}});
  const test::picture_source from(choose(devices().front()->name(), "q12"), false);
  job asked{.of = &of, .width = 200, .height = 200, .shading = &find_shading("phong"), .device = from.of()};
  const outcome on = render::render(asked);
  CHECK(on.tests_left_out > on.pixels);
  CHECK(on.triangles_left_out > on.triangles_visible / 3);
  CHECK(on.triangles_left_out <= on.triangles_visible);
  for (const char* shading : {"phong", "gouraud"}) {
    asked.shading = &find_shading(shading);
    asked.checks_triangles = true;
    const outcome with = render::render(asked);
    asked.checks_triangles = false;
    const outcome off = render::render(asked);
    CHECK(off.tests_left_out == 0);
    CHECK(off.triangles_left_out == 0);
    CHECK(off.image.rgb == with.image.rgb);
    CHECK(off.device_writes == with.device_writes);
    CHECK(off.triangles_in_highlight == with.triangles_in_highlight);
    CHECK((with.tests_left_out > 0) == asked.shading->is_by_pixel);
  }
}

}  // namespace
