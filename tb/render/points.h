// SPDX-License-Identifier: Apache-2.0
/// Where a shading method computes colours, and how a pixel's colour is made of them.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "tb/render/visibility.h"

namespace blysk::render {

/// A point of the surface that is shaded.
struct point {
  vec position;
  vec normal;  ///< unit vector, or 0 where none is defined; on the side that is seen
  std::uint32_t material = 0;
};

/// A pixel's colour: the sum of weighted colours of points. The weights sum to 1.
struct mixture {
  std::size_t count = 0;
  std::array<std::uint32_t, 6> point{};
  std::array<double, 6> weight{};
};

class point_source {
 public:
  /// What neighbouring pixels share; one for each thread.
  struct cursor {
    std::uint32_t triangle = kNoTriangle;
    footprint print;
  };

  virtual ~point_source() = default;
  virtual std::size_t size() const = 0;

  /// \return  false if there is nothing at the index
  virtual bool at(std::size_t index, cursor& near, point& to) const = 0;

  /// The material there; kNoMaterial if there is nothing.
  virtual std::uint32_t material_at(std::size_t index) const = 0;
  static constexpr std::uint32_t kNoMaterial = ~std::uint32_t{0};

  /// \param pixel  that sees a triangle
  virtual mixture of_pixel(std::size_t pixel, cursor& near) const = 0;
};

struct shading_method {
  std::string_view name;
  std::string_view help;
  bool is_by_pixel;  ///< point i is what pixel i sees
  /// The arguments outlive what is made of them.
  /// \param corrected  with perspective correction
  std::unique_ptr<point_source> (*make)(const scene::mesh& surface, const projection& view,
                                        const visibility& seen, bool corrected);
};

/// flat, gouraud, polynomial, phong.
const std::vector<shading_method>& shading_methods();

/// \throws std::invalid_argument for a method that does not exist
const shading_method& find_shading(std::string_view name);

}  // namespace blysk::render
