// SPDX-License-Identifier: Apache-2.0
// The experiments' pictures against those of the golden sphere.
#include "tb/render/experiments/experiments.h"

#include <algorithm>
#include <cmath>

#include "tb/catch.h"
#include "tb/golden/sphere.h"
#include "tb/scene/shapes.h"

namespace {

using namespace blysk;
using namespace blysk::render;

/// NMSE as calcColor of [T] listing A makes it, of a sphere seen from afar: pixel by pixel, nothing sorted or left out.
double literal_nmse(golden::lobe which, int n, const listing_scene& in) {
  const golden::sphere_scene geometry;
  const auto half = golden::half_vector(geometry.light, geometry.view);
  double difference = 0;
  double energy = 0;
  for (const auto& each : golden::sphere_pixels(geometry)) {
    const double nl = std::max(0.0, golden::dot(each.normal, geometry.light));
    const double nh = std::clamp(golden::dot(each.normal, half), 0.0, 1.0);
    const double tried =
        golden::with_lobe(which, static_cast<double>(n), [&](const auto& f) { return std::max(0.0, f(nh)); });
    for (const int colour : in.colour) {
      const int base = colour * static_cast<int>(nl * in.share * 255) / 255;
      const int a = std::min(255, base + static_cast<int>(in.share * std::pow(nh, n) * 255));
      const int b = std::min(255, base + static_cast<int>(in.share * tried * 255));
      difference += (a - b) * (a - b);
      energy += a * a;
    }
  }
  return difference / energy;
}

TEST_CASE("a mesh of a sphere has the NMSE of the sphere", "[render][experiments]") {
  // From 1e6 radii, of which the picture shows 1 / 0.9 on either side of the middle.
  scene::camera far;
  far.eye = {0, 0, 1e6};
  far.fov_deg = 2 * std::atan(1e-6 / 0.9) * 180 / M_PI;
  const listing_picture sphere(scene::make_sphere(200), far);
  CHECK(sphere.pixels() > 100'000);
  for (const golden::lobe which :
       {golden::lobe::cosine_quadratic, golden::lobe::schlick, golden::lobe::quadratic_exact}) {
    for (const int n : {2, 10, 50, 200}) {
      const auto found = sphere.nmse(which, n);
      for (std::size_t s = 0; s < found.size(); ++s) {
        const double expected = literal_nmse(which, n, kListingScenes[s]);
        CAPTURE(golden::name_of(which), n, s);
        CHECK(found[s] == Approx(expected).epsilon(0.02).margin(1e-7));
      }
    }
  }
  for (const double each : sphere.nmse(golden::lobe::blinn, 50)) CHECK(each == 0);
}

}  // namespace
