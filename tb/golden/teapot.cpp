// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/teapot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tb/golden/teapot_patches.h"

namespace blysk::golden {
namespace {

using vec = vec3<double>;

vec cross(const vec& a, const vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

vec between(const vec& a, const vec& b, double t) {
  return a + t * (b - a);
}

/// A point of a cubic Bezier curve and the derivative there, by de Casteljau's construction.
struct curve_point {
  vec at, change;
};
curve_point on_curve(const std::array<vec, 4>& of, double t) {
  const vec first = between(of[0], of[1], t);
  const vec middle = between(of[1], of[2], t);
  const vec last = between(of[2], of[3], t);
  const vec a = between(first, middle, t);
  const vec b = between(middle, last, t);
  return {between(a, b, t), 3.0 * (b - a)};
}

struct corner {
  vec position, normal;
};

using patch = std::array<std::array<vec, 4>, 4>;

patch patch_of(const std::array<std::uint16_t, 16>& points) {
  patch made{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& point = kTeapotPoints[points[i]];
    made[i / 4][i % 4] = {point[0], point[2], -point[1]};  // y upward
  }
  return made;
}

/// \param u  along the rows of the patch, [0, 1]
/// \param v  from its first row to the last, [0, 1]
corner on_patch(const patch& of, double u, double v) {
  std::array<vec, 4> across{}, changes{};
  for (std::size_t row = 0; row < of.size(); ++row) {
    const curve_point point = on_curve(of[row], u);
    across[row] = point.at;
    changes[row] = point.change;
  }
  const curve_point down = on_curve(across, v);
  const vec normal = cross(on_curve(changes, v).at, down.change);
  // At the poles of lid and bottom all points of a row are one: up at the lid's, down at the bottom's.
  if (dot(normal, normal) < 1e-12) return {down.at, {0, down.at.y > 1 ? 1.0 : -1.0, 0}};
  return {down.at, normalised(normal)};
}

using triangle = std::array<corner, 3>;

std::vector<triangle> mesh_of(int density) {
  std::vector<triangle> mesh;
  for (const auto& points : kTeapotPatches) {
    const patch of = patch_of(points);
    const auto at = [&](int column, int row) {
      return on_patch(of, static_cast<double>(column) / density, static_cast<double>(row) / density);
    };
    for (int row = 0; row < density; ++row) {
      for (int column = 0; column < density; ++column) {
        const corner a = at(column, row);
        const corner b = at(column + 1, row);
        const corner c = at(column, row + 1);
        mesh.push_back({a, b, c});
        mesh.push_back({b, at(column + 1, row + 1), c});
      }
    }
  }
  return mesh;
}

/// Rays from the eye through pixels; their part along the view is 1.
class camera {
 public:
  camera(const std::vector<triangle>& mesh, int side) : middle_(side / 2.0) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    vec low{kInfinity, kInfinity, kInfinity};
    vec high = -1.0 * low;
    const auto for_each_corner = [&](const auto& use) {
      for (const triangle& each : mesh) {
        for (const corner& one : each) use(one.position);
      }
    };
    for_each_corner([&](const vec& at) {
      low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
    });
    const vec target = 0.5 * (low + high);
    double square = 0;
    for_each_corner([&](const vec& at) { square = std::max(square, dot(at - target, at - target)); });
    const double field = 2 - std::sqrt(3.0);  // tan 15 degrees
    const double filled = 0.9 * field;
    const vec towards = normalised(vec{0, 0.3, 1});
    eye_ = target + std::sqrt(square * (1 + filled * filled)) / filled * towards;
    forward_ = -1.0 * towards;
    right_ = normalised(cross(forward_, {0, 1, 0}));
    up_ = cross(right_, forward_);
    pixel_ = field / middle_;
  }

  const vec& eye() const { return eye_; }
  vec ray(int x, int y) const {
    return forward_ + pixel_ * (x + 0.5 - middle_) * right_ - pixel_ * (y + 0.5 - middle_) * up_;
  }

  /// Columns and rows of pixels, in fractions, at which the point is seen.
  std::array<double, 2> seen_at(const vec& point) const {
    const vec from_eye = point - eye_;
    const double scale = 1 / (pixel_ * dot(from_eye, forward_));
    return {scale * dot(from_eye, right_) + middle_, middle_ - scale * dot(from_eye, up_)};
  }

 private:
  double middle_, pixel_ = 0;
  vec eye_{}, forward_{}, right_{}, up_{};
};

/// What of the mesh a pixel sees, as far as it is known.
struct hit {
  double distance = std::numeric_limits<double>::infinity();
  vec normal{};
};

/// Moeller, Trumbore 1997.
void cut(const triangle& with, const vec& eye, const vec& ray, hit& nearest) {
  const vec a = with[1].position - with[0].position;
  const vec b = with[2].position - with[0].position;
  const vec p = cross(ray, b);
  const double determinant = dot(a, p);
  if (determinant == 0) return;
  const vec s = eye - with[0].position;
  const double u = dot(s, p) / determinant;
  const vec q = cross(s, a);
  const double v = dot(ray, q) / determinant;
  const double distance = dot(b, q) / determinant;
  if (!(u >= 0 && v >= 0 && u + v <= 1 && distance > 0 && distance < nearest.distance)) return;
  const vec normal = normalised((1 - u - v) * with[0].normal + u * with[1].normal + v * with[2].normal);
  // Corners run counter-clockwise as seen from outside.
  nearest = {distance, determinant > 0 ? normal : -1.0 * normal};
}

}  // namespace

std::vector<teapot_pixel> teapot_pixels(const teapot_scene& scene) {
  const std::vector<triangle> mesh = mesh_of(scene.density);
  const camera from(mesh, scene.side);
  const auto side = static_cast<std::size_t>(scene.side);
  std::vector<hit> hits(side * side);
  for (const triangle& each : mesh) {
    // The pixels whose centres may lie inside.
    std::array<double, 2> low{};
    low.fill(scene.side);
    std::array<double, 2> high{};
    for (const corner& one : each) {
      const std::array<double, 2> at = from.seen_at(one.position);
      for (std::size_t k = 0; k < at.size(); ++k) {
        low[k] = std::min(low[k], at[k]);
        high[k] = std::max(high[k], at[k]);
      }
    }
    const auto pixel = [&](double at) { return std::clamp(static_cast<int>(at), 0, scene.side - 1); };
    for (int y = pixel(low[1]); y <= pixel(high[1]); ++y) {
      for (int x = pixel(low[0]); x <= pixel(high[0]); ++x)
        cut(each, from.eye(), from.ray(x, y),
            hits[static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)]);
    }
  }
  std::vector<teapot_pixel> result;
  for (int y = 0; y < scene.side; ++y) {
    for (int x = 0; x < scene.side; ++x) {
      const hit& at = hits[static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)];
      if (std::isfinite(at.distance)) result.push_back({x, y, at.normal, normalised(-1.0 * from.ray(x, y))});
    }
  }
  return result;
}

}  // namespace blysk::golden
