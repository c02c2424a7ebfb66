// SPDX-License-Identifier: Apache-2.0
// The numbers of Gouraud's faults, as docs/gallery.md states them, against their closed forms.
#include "tb/render/faults/gouraud.h"

#include <cmath>

#include "tb/catch.h"
#include "tb/render/test/picture_source.h"

namespace {

using namespace blysk;
using namespace blysk::render;

const std::vector<gouraud_fault>& faults() {
  static const test::picture_source from(choose(devices().front()->name(), "q16"), false);
  static const std::vector<gouraud_fault> all = find_gouraud_faults(*from.of());
  return all;
}

TEST_CASE("Gouraud a: the middle of a bent square is half as bright as it should be", "[render][gouraud]") {
  // The corners have cos 60 = 1/2, and so has everything between them; the middle has 1, of a diffuse share of 0.8. The
  // pixel nearest to the middle is half a pixel off it: 1 - cos = 2e-5.
  CHECK(faults()[0].gouraud == std::round(0.8 * 255) - std::round(0.4 * 255));
}

TEST_CASE("Gouraud b: a highlight without a corner is lost", "[render][gouraud]") {
  CHECK(faults()[1].gouraud == 0);
  // A disc: N.H = cos(atan(r / 6)) reaches the root of the parabola, 1 - 1/a, a = 0.7869 n - 0.5. The square's side is
  // 2 of the 12 tan(12 degrees) that the picture shows.
  const double a = 0.786938680574733 * 200 - 0.5;
  const double radius = 6 * std::tan(std::acos(1 - 1 / a));
  const double pixel = 12 * std::tan(12 * M_PI / 180) / 150;
  CHECK(faults()[1].other == Approx(M_PI * radius * radius / (pixel * pixel)).epsilon(0.02));
}

TEST_CASE("Gouraud c: a folded sheet looks flat", "[render][gouraud]") {
  CHECK(faults()[2].gouraud == 0);
  // Planes that rise by 0.12 over 0.25: normals (-+0.12, 0, 0.25) / |.|, light (0.6, 0, 0.8).
  const double length = std::hypot(0.12, 0.25);
  const double bright = (0.6 * 0.12 + 0.8 * 0.25) / length;
  const double dark = (-0.6 * 0.12 + 0.8 * 0.25) / length;
  CHECK(faults()[2].other == std::round(0.9 * 255 * bright) - std::round(0.9 * 255 * dark));
  // The normal of an inner corner is the mean of its planes' normals.
  const scene::mesh sheet = make_zigzag();
  const auto plane = [&](std::size_t triangle) {
    const auto& at = sheet.triangles[triangle].position;
    const scene::vec& origin = sheet.positions[at[0]];
    return golden::normalised(scene::cross(sheet.positions[at[1]] - origin, sheet.positions[at[2]] - origin));
  };
  for (std::size_t i = 0; i + 2 < sheet.triangles.size(); i += 2) {
    const scene::vec mean = golden::normalised(plane(i) + plane(i + 2));
    CHECK(golden::dot(mean, sheet.normals[0]) == Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("Gouraud d: a highlight flickers as a sphere turns", "[render][gouraud]") {
  CHECK(faults()[3].gouraud > 40);
  CHECK(faults()[3].other < 4);
}

TEST_CASE("Gouraud e: a highlight is no disc", "[render][gouraud]") {
  CHECK(faults()[4].gouraud > 1.5);
  CHECK(faults()[4].other < 1.15);
  // A disc, a square and a cross.
  picture disc(101, 101);
  picture square(101, 101);
  picture cross(101, 101);
  for (int y = 0; y < 101; ++y) {
    for (int x = 0; x < 101; ++x) {
      const int u = std::abs(x - 50);
      const int v = std::abs(y - 50);
      disc.pixel(x, y)[0] = u * u + v * v <= 1600 ? 200 : 99;
      square.pixel(x, y)[0] = std::max(u, v) <= 40 ? 200 : 99;
      cross.pixel(x, y)[0] = std::max(u, v) <= 40 && std::min(u, v) <= 10 ? 200 : 99;
    }
  }
  CHECK(roundness(disc) == Approx(1).epsilon(0.03));
  CHECK(roundness(square) == Approx(std::sqrt(2)).epsilon(0.03));
  CHECK(roundness(cross) == Approx(40 / std::hypot(11, 11)).epsilon(0.05));
}

TEST_CASE("Gouraud f: a road is too dark nearby", "[render][gouraud]") {
  // Between the near end, 1 at the distance w0, and the far one, 0.28 at w1, a share s of the picture is the share
  // s w0 / (s w0 + (1 - s) w1) of the surface. Their difference is largest at s = 1 / (1 + sqrt(w0 / w1)).
  const double down = std::atan2(1.2, 5);
  const auto depth = [&](double z) { return (3 - z) * std::cos(down) + 1.2 * std::sin(down); };
  const double q = std::sqrt(depth(1) / depth(-20));
  const double s = 1 / (1 + q);
  const double on_surface = s * depth(1) / (s * depth(1) + (1 - s) * depth(-20));
  CHECK(std::abs(faults()[5].gouraud - 255 * 0.9 * 0.72 * (s - on_surface)) <= 1.5);
}

}  // namespace
