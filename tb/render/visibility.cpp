// SPDX-License-Identifier: Apache-2.0
#include "tb/render/visibility.h"

#include <algorithm>
#include <limits>

#include "tb/parallel.h"

namespace blysk::render {
namespace {

constexpr int kBandRows = 16;

/// The part of an edge in front of the eye ends where w is this share of its other end.
constexpr double kNearest = 1e-6;

std::array<vec, 3> corners_of(const scene::mesh& surface, const projection& view, std::uint32_t triangle) {
  const auto& at = surface.triangles[triangle].position;
  return {view.of(surface.positions[at[0]]), view.of(surface.positions[at[1]]),
          view.of(surface.positions[at[2]])};
}

/// The box around what lies in front of the eye.
box box_of(const std::array<vec, 3>& corners, int width, int height) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double low_x = kInfinity;
  double high_x = -kInfinity;
  double low_y = kInfinity;
  double high_y = -kInfinity;
  const auto include = [&](const vec& at) {
    low_x = std::min(low_x, at.x / at.z);
    high_x = std::max(high_x, at.x / at.z);
    low_y = std::min(low_y, at.y / at.z);
    high_y = std::max(high_y, at.y / at.z);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const vec& a = corners[i];
    const vec& b = corners[(i + 1) % 3];
    if (a.z > 0) include(a);
    if ((a.z > 0) == (b.z > 0)) continue;
    // A corner behind the eye: the edge leaves the picture on the way there.
    const double w = kNearest * std::max(a.z, b.z);
    const double share = (w - a.z) / (b.z - a.z);
    include(a + share * (b - a));
  }
  const auto pixel = [](double at, int size) { return static_cast<int>(std::clamp(at, -1.0, size + 1.0)); };
  return {std::max(0, pixel(std::floor(low_x), width)), std::min(width - 1, pixel(std::ceil(high_x), width)),
          std::max(0, pixel(std::floor(low_y), height)),
          std::min(height - 1, pixel(std::ceil(high_y), height))};
}

}  // namespace

footprint footprint_of(const scene::mesh& surface, const projection& view, std::uint32_t triangle) {
  return footprint(corners_of(surface, view, triangle));
}

visibility find_visible(const scene::mesh& surface, const projection& view, int width, int height,
                        unsigned threads) {
  visibility seen{width, height, {}};
  seen.triangle.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kNoTriangle);
  std::vector<box> boxes(surface.triangles.size());
  constexpr std::size_t kChunk = 4096;
  for_each_in_parallel((boxes.size() + kChunk - 1) / kChunk, threads, [&](std::size_t chunk, unsigned) {
    const std::size_t end = std::min(boxes.size(), (chunk + 1) * kChunk);
    for (std::size_t i = chunk * kChunk; i < end; ++i)
      boxes[i] = box_of(corners_of(surface, view, static_cast<std::uint32_t>(i)), width, height);
  });
  const auto bands = static_cast<std::size_t>((height + kBandRows - 1) / kBandRows);
  for_each_in_parallel(bands, threads, [&](std::size_t band, unsigned) {
    const int top = static_cast<int>(band) * kBandRows;
    const int bottom = std::min(height, top + kBandRows) - 1;
    std::vector<double> nearest(static_cast<std::size_t>(width) * kBandRows, 0);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      const box& around = boxes[i];
      if (around.first_y > bottom || around.last_y < top || around.first_x > around.last_x) continue;
      const footprint print = footprint_of(surface, view, i);
      if (!print.has_area()) continue;
      footprint::weights sides{};
      for (int y = std::max(top, around.first_y); y <= std::min(bottom, around.last_y); ++y) {
        for (int x = around.first_x; x <= around.last_x; ++x) {
          if (!print.covers(x + 0.5, y + 0.5, sides)) continue;
          const double nearness = print.nearness(sides);
          double& before = nearest[static_cast<std::size_t>(y - top) * static_cast<std::size_t>(width) +
                                   static_cast<std::size_t>(x)];
          if (!(nearness > before)) continue;
          before = nearness;
          seen.triangle[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(x)] = i;
        }
      }
    }
  });
  return seen;
}

namespace {

constexpr int kTile = 8;  // pixels of a side

std::size_t tile_of(int pixel) {
  return static_cast<std::size_t>(pixel / kTile);
}

}  // namespace

ray_caster::ray_caster(const scene::mesh& surface, const projection& view, int width, int height)
    : surface_(surface),
      view_(view),
      tiles_across_(tile_of(width - 1) + 1),
      of_tile_(tiles_across_ * (tile_of(height - 1) + 1)) {
  for (std::uint32_t i = 0; i < surface.triangles.size(); ++i) {
    const box& around = boxes_.emplace_back(box_of(corners_of(surface, view, i), width, height));
    if (around.first_y > around.last_y || around.first_x > around.last_x) continue;
    for (std::size_t y = tile_of(around.first_y); y <= tile_of(around.last_y); ++y) {
      for (std::size_t x = tile_of(around.first_x); x <= tile_of(around.last_x); ++x)
        of_tile_[y * tiles_across_ + x].push_back(i);
    }
  }
}

std::uint32_t ray_caster::triangle_at(int x, int y) const {
  std::uint32_t seen = kNoTriangle;
  double nearest = 0;
  for (const std::uint32_t each : of_tile_[tile_of(y) * tiles_across_ + tile_of(x)]) {
    const box& around = boxes_[each];
    if (x < around.first_x || x > around.last_x || y < around.first_y || y > around.last_y) continue;
    const footprint print = footprint_of(surface_, view_, each);
    footprint::weights sides{};
    if (!print.has_area() || !print.covers(x + 0.5, y + 0.5, sides)) continue;
    const double nearness = print.nearness(sides);
    if (!(nearness > nearest)) continue;
    nearest = nearness;
    seen = each;
  }
  return seen;
}

}  // namespace blysk::render
