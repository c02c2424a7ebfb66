// SPDX-License-Identifier: Apache-2.0
#include "tb/render/visibility.h"

#include <algorithm>
#include <limits>

#include "tb/parallel.h"

namespace blysk::render {
namespace {

constexpr int kBandRows = 16;

std::array<vec, 3> corners_of(const scene::mesh& surface, const projection& view, std::uint32_t triangle) {
  const auto& at = surface.triangles[triangle].position;
  return {view.of(surface.positions[at[0]]), view.of(surface.positions[at[1]]),
          view.of(surface.positions[at[2]])};
}

/// The box around what lies in front of the eye. Where an edge comes beside the eye, at w = 0, it has left the picture: which
/// side it leaves to is x, both sides where x is but a rounding: a box too large takes time alone.
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
  const auto leave = [&](double at, double size, double& low, double& high) {
    constexpr double kRounding = 1e-9;
    if (at <= kRounding * size) low = -kInfinity;
    if (at >= -kRounding * size) high = kInfinity;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const vec& a = corners[i];
    const vec& b = corners[(i + 1) % 3];
    if (a.z > 0) include(a);
    if ((a.z > 0) == (b.z > 0)) continue;
    const vec beside = a + (-a.z / (b.z - a.z)) * (b - a);
    leave(beside.x, std::max(std::abs(a.x), std::abs(b.x)), low_x, high_x);
    leave(beside.y, std::max(std::abs(a.y), std::abs(b.y)), low_y, high_y);
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

bool is_empty(const box& of) {
  return of.first_y > of.last_y || of.first_x > of.last_x;
}

/// Pixels of a tile's side: the lists of all tiles together are no longer than a few times the triangles, or the picture.
int side_of_tiles(const std::vector<box>& boxes, int width, int height) {
  constexpr std::size_t kMostOfEach = 8;
  const int whole = std::max(width, height);
  const std::size_t most = std::max(kMostOfEach * boxes.size(),
                                    static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int side = 8; side < whole; side *= 2) {
    std::size_t entries = 0;
    for (const box& each : boxes) {
      if (is_empty(each)) continue;
      entries += static_cast<std::size_t>(each.last_x / side - each.first_x / side + 1) *
                 static_cast<std::size_t>(each.last_y / side - each.first_y / side + 1);
    }
    if (entries <= most) return side;
  }
  return whole;
}

std::vector<box> boxes_of(const scene::mesh& surface, const projection& view, int width, int height) {
  std::vector<box> boxes;
  boxes.reserve(surface.triangles.size());
  for (std::uint32_t i = 0; i < surface.triangles.size(); ++i)
    boxes.push_back(box_of(corners_of(surface, view, i), width, height));
  return boxes;
}

}  // namespace

ray_caster::ray_caster(const scene::mesh& surface, const projection& view, int width, int height)
    : surface_(surface),
      view_(view),
      boxes_(boxes_of(surface, view, width, height)),
      side_(side_of_tiles(boxes_, width, height)),
      tiles_across_(tile_of(width - 1) + 1),
      of_tile_(tiles_across_ * (tile_of(height - 1) + 1)) {
  for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
    const box& around = boxes_[i];
    if (is_empty(around)) continue;
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
