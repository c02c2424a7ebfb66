// SPDX-License-Identifier: Apache-2.0
/// A mesh from the polygons of a file.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tb/scene/scene.h"

namespace blysk::scene {

class mesh_builder {
 public:
  static constexpr std::uint32_t kNoNormal = ~std::uint32_t{0};

  /// Smoothing groups: faces of one group share normals. Of a file that says nothing of it, faces that meet at less than
  /// 60 degrees do.
  static constexpr std::int32_t kFlat = 0;
  static constexpr std::int32_t kUnsaid = -1;

  /// Corners of a polygon that is not convex: cutting it takes the square of their number and more.
  static constexpr std::size_t kMostConcave = 2000;

  /// Faces at one place that are smoothed: each is compared with each.
  static constexpr std::size_t kMostFaces = 1000;

  struct corner {
    std::uint32_t position;
    std::uint32_t normal = kNoNormal;
  };

  std::vector<vec> positions;
  std::vector<vec> normals;  ///< as given, of any length
  std::vector<material> materials;

  /// Appends a polygon of at least three corners, cut into triangles. What has no area is dropped and counted. One that
  /// cuts itself, or is not convex and has more than kMostConcave corners, is cut as if it were convex, and counted.
  void add(std::span<const corner> polygon, std::uint32_t material, std::int32_t smoothing);

  std::size_t triangles() const { return triangles_.size(); }

  /// The mesh: normals computed where none was given, triangles turned so that their normals point outwards.
  /// \param messages  gets a line for what was dropped and one for what was computed
  mesh finish(std::vector<std::string>& messages) &&;

 private:
  void append(const corner& a, const corner& b, const corner& c, std::uint32_t material,
              std::int32_t smoothing);
  vec area_of(const triangle& of) const;
  void turn_outwards();
  void compute_normals(std::vector<std::string>& messages);

  /// The areas of the polygons around a corner that its face meets smoothly, added up, each polygon once however it was
  /// cut into triangles.
  /// \param around  a triangle of each polygon there
  /// \param areas   of the polygon of each triangle
  vec smooth_area(std::uint32_t face, std::span<const std::uint32_t> around,
                  const std::vector<vec>& areas) const;

  std::vector<triangle> triangles_;
  std::vector<std::int32_t> smoothing_;  // of the triangles
  std::vector<std::uint32_t> polygon_;   // that each was cut from, counted from 1
  std::uint32_t polygons_ = 0;
  std::size_t dropped_ = 0;
  std::size_t crossed_ = 0;
  std::size_t turned_ = 0;
};

}  // namespace blysk::scene
