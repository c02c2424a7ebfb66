// SPDX-License-Identifier: Apache-2.0
// Why most_half_cosine() is a bound.
//
// 1. A pixel's shares s of the corners are not negative: footprint::covers() has found the numbers that they are made of
//    not negative, by the same operations (-ffp-contract=off). Without perspective correction they are multiplied by the
//    corners' depths, which are all positive, else no bound is given.
// 2. Vectors x_i with x_i.A >= |x_i| cos(a), 0 <= a <= 90 degrees, have
//    (sum s_i x_i).A >= cos(a) sum s_i |x_i| >= cos(a) |sum s_i x_i|: a sum of the corners' normals lies in their cone, and
//    eye - p = sum s_i (eye - p_i) in that of the corners' views, as does light - p for a light at a place.
// 3. A unit vector of a cone with axis A is at most sqrt(2 - 2 cos(a)) away from A. So L + V is at most d away from the sum
//    u of the two axes, d the sum of the two distances, and the angle of H to u is at most h = asin(d / |u|), d < |u|.
// 4. N is at most a away from its axis and H at most h from u, whose angle is t: the angle of N and H is at least t - a - h,
//    and if that is not negative, N.H <= cos(t - (a + h)).
//
// Roundings, epsilon = 2^-52. The cosine of a cone is off by less than 10 epsilon and lowered by 1e-12, which widens the
// cone; then 1 - cos^2 is at least 2e-12, and the root of it exact to 1e-10. The root of 1 - cos^2(t) is off by at most
// sqrt(20 epsilon) < 7e-8. Of the renderer: a cone of at most 60 degrees makes |sum s_i n_i| at least half of
// sum s_i |n_i|, so N is exact to 20 epsilon; p to 14 epsilon of the largest coordinate, which is at most 1e5 times the
// distance to the nearest corner, twice that of p: 1e-9 of L and V, and, with |L + V| >= |u| / 2 >= 0.1, 4e-8 of H. The sum
// is below 3e-7.
#include "tb/render/inner_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tb/parallel.h"

namespace blysk::render {
namespace {

std::optional<cone> cone_of(const std::array<vec, 3>& directions) {
  constexpr double kWidened = 1e-12;
  std::array<vec, 3> units;
  std::ranges::transform(directions, units.begin(), golden::normalised<double>);
  const vec axis = golden::normalised(units[0] + units[1] + units[2]);
  double least = 1;
  for (const vec& each : units) least = std::min(least, golden::dot(each, axis));
  if (!(least > 0.5 + kWidened)) return {};  // a vector without a direction, too
  return cone{axis, least - kWidened};
}

/// Of the directions from the points of a triangle to a place.
std::optional<cone> cone_towards(const vec& place, const std::array<vec, 3>& corners) {
  constexpr double kFarthest = 1e5;
  std::array<vec, 3> directions;
  double largest = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const vec& at = corners[i];
    directions[i] = place - at;
    largest = std::max({largest, std::abs(at.x), std::abs(at.y), std::abs(at.z)});
    nearest = std::min(nearest, golden::dot(directions[i], directions[i]));
  }
  if (!(largest * largest <= kFarthest * kFarthest * nearest)) return {};
  return cone_of(directions);
}

/// How far a unit vector of the cone may be from its axis.
double spread(const cone& of) {
  return std::sqrt(2 * (1 - of.cosine));
}

/// The sine of a cosine in [0, 180] degrees, the cosine of a sine in [0, 90].
double other_leg(double leg) {
  return std::sqrt(std::max(0.0, 1 - leg * leg));
}

}  // namespace

highlight_bound::highlight_bound(const scene::mesh& surface, const projection& view, std::uint32_t triangle,
                                 bool corrected) {
  const scene::triangle& of = surface.triangles[triangle];
  const double side = footprint_of(surface, view, triangle).is_front() ? 1 : -1;
  std::array<vec, 3> normals;
  bool is_before = true;
  for (std::size_t i = 0; i < 3; ++i) {
    corners_[i] = surface.positions[of.position[i]];
    normals[i] = side * surface.normals[of.normal[i]];
    is_before = is_before && view.of(corners_[i]).z > 0;
  }
  if (!corrected && !is_before) return;
  normals_ = cone_of(normals);
  views_ = cone_towards(view.eye(), corners_);
}

double highlight_bound::most_half_cosine(const scene::light& light) const {
  if (!normals_ || !views_) return 1;
  const std::optional<cone> lights = light.is_point ? cone_towards(light.at, corners_) : cone{light.at, 1};
  if (!lights) return 1;
  const vec sum = lights->axis + views_->axis;
  const double length = std::sqrt(golden::dot(sum, sum));
  const double away = spread(*lights) + spread(*views_);
  if (!(length >= 0.2 && 2 * away <= length)) return 1;
  const double sine_halves = away / length;
  const double cosine_halves = other_leg(sine_halves);
  const double sine_normals = other_leg(normals_->cosine);
  const double cosine_both = normals_->cosine * cosine_halves - sine_normals * sine_halves;
  const double sine_both = sine_normals * cosine_halves + normals_->cosine * sine_halves;
  const double along = golden::dot(normals_->axis, sum) / length;
  if (along >= cosine_both) return 1;
  return along * cosine_both + other_leg(along) * sine_both;
}

std::vector<light_set> find_dark_lights(const scene::mesh& surface, const projection& view,
                                        const visibility& seen, const std::vector<scene::light>& lights,
                                        const plan& planned, bool corrected, unsigned threads) {
  constexpr std::uint32_t kLeastPixels = 32;
  constexpr std::size_t kChunk = 1024;
  std::vector<std::uint32_t> pixels(surface.triangles.size(), 0);
  for (const std::uint32_t each : seen.triangle) {
    if (each != kNoTriangle) ++pixels[each];
  }
  const std::vector<light_set> specular = planned.specular_lights();
  std::vector<light_set> dark(pixels.size(), 0);
  for_each_in_parallel((pixels.size() + kChunk - 1) / kChunk, threads, [&](std::size_t chunk, unsigned) {
    const std::size_t end = std::min(pixels.size(), (chunk + 1) * kChunk);
    for (std::size_t i = chunk * kChunk; i < end; ++i) {
      const std::uint32_t material = surface.triangles[i].material;
      if (pixels[i] < kLeastPixels || specular[material] == 0) continue;
      const highlight_bound bound(surface, view, static_cast<std::uint32_t>(i), corrected);
      for (std::size_t k = 0; k < lights.size(); ++k) {
        if ((specular[material] >> k & 1) == 0) continue;
        const double most = bound.most_half_cosine(lights[k]) + highlight_bound::kMargin;
        if (most < planned.at(material, k).below_lobe) dark[i] |= light_set{1} << k;
      }
    }
  });
  return dark;
}

}  // namespace blysk::render
