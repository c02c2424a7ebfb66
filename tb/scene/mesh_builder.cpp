// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/mesh_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace blysk::scene {
namespace {

using golden::dot;

struct flat_point {
  double x, y;
};

double turn(const flat_point& a, const flat_point& b, const flat_point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Newell's normal: twice the area, along the polygon's normal.
vec normal_of(const std::vector<vec>& corners) {
  vec sum{0, 0, 0};
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum = sum + cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
  return golden::normalised(sum);
}

/// The polygon in the plane of its two largest extents, counter-clockwise; empty where its parts cancel out.
std::vector<flat_point> flattened(const std::vector<vec>& corners) {
  const vec normal = normal_of(corners);
  if (dot(normal, normal) == 0) return {};
  const double x = std::abs(normal.x);
  const double y = std::abs(normal.y);
  const double z = std::abs(normal.z);
  std::vector<flat_point> flat;
  for (const vec& at : corners) {
    if (z >= x && z >= y) {
      flat.push_back(normal.z >= 0 ? flat_point{at.x, at.y} : flat_point{at.y, at.x});
    } else if (x >= y) {
      flat.push_back(normal.x >= 0 ? flat_point{at.y, at.z} : flat_point{at.z, at.y});
    } else {
      flat.push_back(normal.y >= 0 ? flat_point{at.z, at.x} : flat_point{at.x, at.z});
    }
  }
  return flat;
}

bool is_convex(const std::vector<flat_point>& flat) {
  const std::size_t size = flat.size();
  if (size < 3) return false;
  int sign_changes = 0;  // of the edges' x direction: two in a polygon that goes around once
  double before = 0;
  for (std::size_t i = 0; i < size; ++i) {
    if (turn(flat[i], flat[(i + 1) % size], flat[(i + 2) % size]) < 0) return false;
  }
  for (std::size_t i = 0; i <= size; ++i) {
    const double step = flat[(i + 1) % size].x - flat[i % size].x;
    if (step == 0) continue;
    if (before != 0 && (step > 0) != (before > 0)) ++sign_changes;
    before = step;
  }
  return sign_changes <= 2;
}

/// Triangles of a polygon that is not convex, as indices: ears are cut off one by one. Fewer than size - 2 if it cuts itself.
std::vector<std::array<std::size_t, 3>> cut_ears(const std::vector<flat_point>& flat) {
  std::vector<std::size_t> left(flat.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  std::vector<std::array<std::size_t, 3>> ears;
  const auto is_ear = [&](std::size_t at) {
    const std::size_t size = left.size();
    const flat_point& a = flat[left[(at + size - 1) % size]];
    const flat_point& b = flat[left[at]];
    const flat_point& c = flat[left[(at + 1) % size]];
    if (turn(a, b, c) < 0) return false;
    return std::ranges::none_of(left, [&](std::size_t other) {
      const flat_point& p = flat[other];
      const auto same = [&p](const flat_point& q) { return p.x == q.x && p.y == q.y; };
      return !same(a) && !same(b) && !same(c) && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
             turn(c, a, p) >= 0;
    });
  };
  std::size_t at = 0;
  std::size_t tried = 0;
  while (left.size() > 3 && tried < left.size()) {
    if (!is_ear(at)) {
      at = (at + 1) % left.size();
      ++tried;
      continue;
    }
    const std::size_t size = left.size();
    ears.push_back({left[(at + size - 1) % size], left[at], left[(at + 1) % size]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    at %= left.size();
    tried = 0;
  }
  if (left.size() == 3 && turn(flat[left[0]], flat[left[1]], flat[left[2]]) >= 0)
    ears.push_back({left[0], left[1], left[2]});
  return ears;
}

/// Index of the first of the equal places, for each position.
std::vector<std::uint32_t> welded(const std::vector<vec>& positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t i) { return std::tie(positions[i].x, positions[i].y, positions[i].z); };
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple_cat(key(a), std::tie(a)) < std::tuple_cat(key(b), std::tie(b));
  });
  std::vector<std::uint32_t> first(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
  return first;
}

/// The polygons that have a corner at a place, each by its first triangle there, one list after the other.
class faces_by_place {
 public:
  /// \param polygon  of each triangle; those of one stand side by side
  faces_by_place(const std::vector<vec>& positions, const std::vector<triangle>& triangles,
                 const std::vector<std::uint32_t>& polygon)
      : place_(welded(positions)), begins_(positions.size() + 1, 0) {
    const auto for_each_first = [&](const auto& use) {
      std::vector<std::uint32_t> last(positions.size(), 0);  // polygons are counted from 1
      for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        for (const std::uint32_t index : triangles[i].position) {
          if (std::exchange(last[place_[index]], polygon[i]) != polygon[i]) use(place_[index], i);
        }
      }
    };
    for_each_first([&](std::uint32_t place, std::uint32_t) { ++begins_[place + 1]; });
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    std::vector<std::uint32_t> ends(begins_.begin(), begins_.end() - 1);
    faces_.resize(begins_.back());
    for_each_first([&](std::uint32_t place, std::uint32_t i) { faces_[ends[place]++] = i; });
  }

  /// \param position  of a corner
  std::span<const std::uint32_t> of(std::uint32_t position) const {
    const std::uint32_t at = place_[position];
    return std::span(faces_).subspan(begins_[at], begins_[at + 1] - begins_[at]);
  }

 private:
  std::vector<std::uint32_t> place_;   // of each position: the first of the equal ones
  std::vector<std::uint32_t> begins_;  // of the list of each place, and the end of the last one
  std::vector<std::uint32_t> faces_;
};

}  // namespace

void mesh_builder::append(const corner& a, const corner& b, const corner& c, std::uint32_t material,
                          std::int32_t smoothing) {
  const triangle made{{a.position, b.position, c.position}, {a.normal, b.normal, c.normal}, material};
  const vec area = area_of(made);
  if (area.x == 0 && area.y == 0 && area.z == 0) {
    ++dropped_;
    return;
  }
  triangles_.push_back(made);
  smoothing_.push_back(smoothing);
  polygon_.push_back(polygons_);
}

vec mesh_builder::area_of(const triangle& of) const {
  const vec& origin = positions[of.position[0]];
  return cross(positions[of.position[1]] - origin, positions[of.position[2]] - origin);
}

void mesh_builder::add(std::span<const corner> polygon, std::uint32_t material, std::int32_t smoothing) {
  bool is_crossed = false;
  ++polygons_;
  if (polygon.size() > 3) {
    std::vector<vec> corners;
    for (const corner& each : polygon) corners.push_back(positions[each.position]);
    const std::vector<flat_point> flat = flattened(corners);
    if (!is_convex(flat)) {
      const auto ears =
          polygon.size() <= kMostConcave ? cut_ears(flat) : std::vector<std::array<std::size_t, 3>>{};
      if (ears.size() == polygon.size() - 2) {
        for (const auto& [a, b, c] : ears) append(polygon[a], polygon[b], polygon[c], material, smoothing);
        return;
      }
      is_crossed = true;
    }
  }
  const std::size_t before = triangles_.size();
  for (std::size_t i = 2; i < polygon.size(); ++i)
    append(polygon[0], polygon[i - 1], polygon[i], material, smoothing);
  if (is_crossed && triangles_.size() > before) ++crossed_;
}

/// Files that wind their faces clockwise give themselves away by their normals.
void mesh_builder::turn_outwards() {
  for (triangle& each : triangles_) {
    vec sum{0, 0, 0};
    for (const std::uint32_t index : each.normal) {
      if (index != kNoNormal) sum = sum + normals[index];
    }
    if (dot(area_of(each), sum) >= 0) continue;
    std::swap(each.position[1], each.position[2]);
    std::swap(each.normal[1], each.normal[2]);
    ++turned_;
  }
}

void mesh_builder::compute_normals(std::vector<std::string>& messages) {
  const auto lacks = [](const triangle& of) {
    return std::ranges::find(of.normal, kNoNormal) != of.normal.end();
  };
  if (std::ranges::none_of(triangles_, lacks)) return;
  std::vector<vec> areas;
  for (const triangle& each : triangles_) areas.push_back(area_of(each));
  // The triangles of a polygon stand side by side; each gets the area of all.
  for (std::size_t first = 0, end = 0; first < areas.size(); first = end) {
    vec sum{0, 0, 0};
    for (; end < areas.size() && polygon_[end] == polygon_[first]; ++end) sum = sum + areas[end];
    std::fill(areas.begin() + static_cast<std::ptrdiff_t>(first),
              areas.begin() + static_cast<std::ptrdiff_t>(end), sum);
  }
  const faces_by_place around(positions, triangles_, polygon_);
  std::size_t count = 0;
  std::size_t crowded = 0;
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& normal = triangles_[i].normal[k];
      if (normal != kNoNormal) continue;
      normal = static_cast<std::uint32_t>(normals.size());
      const std::span<const std::uint32_t> faces = around.of(triangles_[i].position[k]);
      if (faces.size() > kMostFaces) ++crowded;
      const vec mean = golden::normalised(smooth_area(i, faces, areas));
      normals.push_back(dot(mean, mean) > 0 ? mean : golden::normalised(area_of(triangles_[i])));
      ++count;
    }
  }
  messages.push_back(fmt::format("{} normals computed, as the file has none there", count));
  if (crowded > 0)
    messages.push_back(
        fmt::format("{} corners not smoothed, where more than {} faces meet", crowded, kMostFaces));
}

vec mesh_builder::smooth_area(std::uint32_t face, std::span<const std::uint32_t> around,
                              const std::vector<vec>& areas) const {
  constexpr double kCrease = 0.5;  // cos of 60 degrees
  if (around.size() > kMostFaces) return areas[face];
  const auto is_smooth_with = [&](std::uint32_t other) {
    if (polygon_[face] == polygon_[other]) return true;
    if (smoothing_[face] != smoothing_[other] || smoothing_[face] == kFlat) return false;
    return smoothing_[face] != kUnsaid ||
           dot(golden::normalised(areas[face]), golden::normalised(areas[other])) > kCrease;
  };
  vec sum{0, 0, 0};
  for (const std::uint32_t other : around) {
    if (is_smooth_with(other)) sum = sum + areas[other];
  }
  return sum;
}

mesh mesh_builder::finish(std::vector<std::string>& messages) && {
  std::size_t without_direction = 0;
  for (vec& each : normals) each = golden::normalised(each);
  for (triangle& each : triangles_) {
    for (std::uint32_t& index : each.normal) {
      if (index == kNoNormal || dot(normals[index], normals[index]) > 0) continue;
      index = kNoNormal;
      ++without_direction;
    }
  }
  if (dropped_ > 0) messages.push_back(fmt::format("{} triangles without area dropped", dropped_));
  if (crossed_ > 0)
    messages.push_back(
        fmt::format("{} polygons that cut themselves, or of more than {} corners, taken as convex", crossed_,
                    kMostConcave));
  if (without_direction > 0)
    messages.push_back(fmt::format("{} normals of length 0 dropped", without_direction));
  turn_outwards();
  if (turned_ > 0)
    messages.push_back(fmt::format("{} triangles turned to face as their normals do", turned_));
  compute_normals(messages);
  return {std::move(positions), std::move(normals), std::move(triangles_), std::move(materials)};
}

}  // namespace blysk::scene
