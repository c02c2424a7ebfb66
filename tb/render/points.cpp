// SPDX-License-Identifier: Apache-2.0
#include "tb/render/points.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>

namespace blysk::render {
namespace {

using footprint_weights = footprint::weights;

/// What all methods know.
class source_base : public point_source {
 public:
  source_base(const scene::mesh& surface, const projection& view, const visibility& seen, bool corrected)
      : surface_(surface), view_(view), seen_(seen), corrected_(corrected) {}

 protected:
  const footprint& print_of(std::uint32_t triangle, cursor& near) const {
    if (near.triangle != triangle) {
      near.print = footprint_of(surface_, view_, triangle);
      near.triangle = triangle;
    }
    return near.print;
  }

  footprint_weights shares_of(std::size_t pixel, cursor& near) const {
    const auto width = static_cast<std::size_t>(seen_.width);
    const std::size_t row = pixel / width;
    return print_of(seen_.triangle[pixel], near)
        .shares(static_cast<double>(pixel % width) + 0.5, static_cast<double>(row) + 0.5, corrected_);
  }

  /// The point with these shares of a triangle's corners.
  point interpolated(std::uint32_t triangle, const footprint_weights& shares, bool is_front) const {
    const scene::triangle& of = surface_.triangles[triangle];
    point made{{0, 0, 0}, {0, 0, 0}, of.material};
    for (std::size_t i = 0; i < 3; ++i) {
      made.position = made.position + shares[i] * surface_.positions[of.position[i]];
      made.normal = made.normal + shares[i] * surface_.normals[of.normal[i]];
    }
    made.normal = golden::normalised(is_front ? made.normal : -1.0 * made.normal);
    return made;
  }

  /// Triangles that a pixel sees, in their order, and at each its place in the list.
  void list_visible() {
    rank_.assign(surface_.triangles.size(), kNoTriangle);
    for (const std::uint32_t each : seen_.triangle) {
      if (each != kNoTriangle) rank_[each] = 0;
    }
    for (std::uint32_t i = 0; i < rank_.size(); ++i) {
      if (rank_[i] == kNoTriangle) continue;
      rank_[i] = static_cast<std::uint32_t>(visible_.size());
      visible_.push_back(i);
    }
  }

  const scene::mesh& surface_;
  const projection& view_;
  const visibility& seen_;
  const bool corrected_;
  std::vector<std::uint32_t> visible_, rank_;
};

/// Bui-Tuong Phong 1975: the normal is interpolated, every pixel is a point.
class phong_source final : public source_base {
 public:
  using source_base::source_base;
  std::size_t size() const override { return seen_.pixels(); }

  bool at(std::size_t index, cursor& near, point& to) const override {
    const std::uint32_t triangle = seen_.triangle[index];
    if (triangle == kNoTriangle) return false;
    const footprint_weights shares = shares_of(index, near);
    to = interpolated(triangle, shares, near.print.is_front());
    return true;
  }

  std::uint32_t material_at(std::size_t index) const override {
    const std::uint32_t triangle = seen_.triangle[index];
    return triangle == kNoTriangle ? kNoMaterial : surface_.triangles[triangle].material;
  }

  mixture of_pixel(std::size_t pixel, cursor&) const override {
    mixture made;
    made.count = 1;
    made.point[0] = static_cast<std::uint32_t>(pixel);
    made.weight[0] = 1;
    return made;
  }
};

/// One colour a triangle: that of its middle, with the normal of its plane.
class flat_source final : public source_base {
 public:
  flat_source(const scene::mesh& surface, const projection& view, const visibility& seen, bool corrected)
      : source_base(surface, view, seen, corrected) {
    list_visible();
  }
  std::size_t size() const override { return visible_.size(); }

  bool at(std::size_t index, cursor& near, point& to) const override {
    const std::uint32_t triangle = visible_[index];
    const bool is_front = print_of(triangle, near).is_front();
    constexpr double kThird = 1.0 / 3;
    to = interpolated(triangle, {kThird, kThird, kThird}, true);
    const auto& corners = surface_.triangles[triangle].position;
    const vec& origin = surface_.positions[corners[0]];
    const vec area =
        scene::cross(surface_.positions[corners[1]] - origin, surface_.positions[corners[2]] - origin);
    to.normal = golden::normalised(is_front ? area : -1.0 * area);
    return true;
  }

  std::uint32_t material_at(std::size_t index) const override {
    return surface_.triangles[visible_[index]].material;
  }

  mixture of_pixel(std::size_t pixel, cursor&) const override {
    mixture made;
    made.count = 1;
    made.point[0] = rank_[seen_.triangle[pixel]];
    made.weight[0] = 1;
    return made;
  }
};

/// Colours at the corners, and in the middles of the edges if they are asked for. Triangles share the points that are the
/// same in place, normal and material.
class corner_source : public source_base {
 public:
  corner_source(const scene::mesh& surface, const projection& view, const visibility& seen, bool corrected,
                bool middles)
      : source_base(surface, view, seen, corrected), per_triangle_(middles ? 6 : 3) {
    list_visible();
    std::map<key, std::uint32_t> known;
    cursor near;
    for (const std::uint32_t triangle : visible_) {
      const bool is_front = print_of(triangle, near).is_front();
      for (std::size_t k = 0; k < per_triangle_; ++k) {
        const auto [found, is_new] =
            known.try_emplace(key_of(triangle, k, is_front), static_cast<std::uint32_t>(first_use_.size()));
        if (is_new) first_use_.push_back({triangle, k, is_front});
        points_.push_back(found->second);
      }
    }
  }
  std::size_t size() const override { return first_use_.size(); }

  bool at(std::size_t index, cursor&, point& to) const override {
    const auto& [triangle, k, is_front] = first_use_[index];
    footprint_weights shares{0, 0, 0};
    if (k < 3) {
      shares[k] = 1;
    } else {
      shares[k - 3] = shares[(k - 2) % 3] = 0.5;
    }
    to = interpolated(triangle, shares, is_front);
    return true;
  }

  std::uint32_t material_at(std::size_t index) const override {
    return surface_.triangles[first_use_[index].triangle].material;
  }

 protected:
  mixture points_at(std::size_t pixel) const {
    mixture made;
    made.count = per_triangle_;
    const std::size_t first = rank_[seen_.triangle[pixel]] * per_triangle_;
    for (std::size_t k = 0; k < per_triangle_; ++k) made.point[k] = points_[first + k];
    return made;
  }

 private:
  /// Position and normal of the one corner or the two, in rising order, material and side.
  using key = std::tuple<std::uint64_t, std::uint64_t, std::uint32_t, bool>;
  struct use {
    std::uint32_t triangle;
    std::size_t corner;
    bool is_front;
  };

  key key_of(std::uint32_t triangle, std::size_t k, bool is_front) const {
    const scene::triangle& of = surface_.triangles[triangle];
    const auto corner = [&](std::size_t i) { return std::uint64_t{of.position[i]} << 32 | of.normal[i]; };
    std::uint64_t a = corner(k % 3);
    std::uint64_t b = k < 3 ? a : corner((k + 1) % 3);
    if (b < a) std::swap(a, b);
    return {a, b, of.material, is_front};
  }

  std::size_t per_triangle_;
  std::vector<use> first_use_;
  std::vector<std::uint32_t> points_;  // of the visible triangles
};

/// Henri Gouraud 1971: colours of the corners, interpolated.   [T] (1.11)
class gouraud_source final : public corner_source {
 public:
  gouraud_source(const scene::mesh& surface, const projection& view, const visibility& seen, bool corrected)
      : corner_source(surface, view, seen, corrected, false) {}

  mixture of_pixel(std::size_t pixel, cursor& near) const override {
    mixture made = points_at(pixel);
    const footprint_weights shares = shares_of(pixel, near);
    std::ranges::copy(shares, made.weight.begin());
    return made;
  }
};

/// The polynomial of second degree through the colours of the corners and of the edges' middles.   [T] listing A
class polynomial_source final : public corner_source {
 public:
  polynomial_source(const scene::mesh& surface, const projection& view, const visibility& seen,
                    bool corrected)
      : corner_source(surface, view, seen, corrected, true) {}

  mixture of_pixel(std::size_t pixel, cursor& near) const override {
    mixture made = points_at(pixel);
    const footprint_weights s = shares_of(pixel, near);
    for (std::size_t k = 0; k < 3; ++k) {
      made.weight[k] = s[k] * (2 * s[k] - 1);
      made.weight[k + 3] = 4 * s[k] * s[(k + 1) % 3];
    }
    return made;
  }
};

template <class Source>
std::unique_ptr<point_source> make(const scene::mesh& surface, const projection& view, const visibility& seen,
                                   bool corrected) {
  return std::make_unique<Source>(surface, view, seen, corrected);
}

}  // namespace

const std::vector<shading_method>& shading_methods() {
  static const std::vector<shading_method> all{
      {"flat", "a colour a triangle", false, make<flat_source>},
      {"gouraud", "colours of the corners, interpolated", false, make<gouraud_source>},
      {"polynomial", "of second degree through corners and edges' middles", false, make<polynomial_source>},
      {"phong", "every pixel by its own normal", true, make<phong_source>},
  };
  return all;
}

const shading_method& find_shading(std::string_view name) {
  for (const shading_method& each : shading_methods()) {
    if (each.name == name) return each;
  }
  std::string names;
  for (const shading_method& each : shading_methods())
    names += fmt::format("{}{}", names.empty() ? "" : ", ", each.name);
  throw std::invalid_argument(fmt::format("shading {} does not exist, expected {}", name, names));
}

}  // namespace blysk::render
