// SPDX-License-Identifier: Apache-2.0
/// Which triangle each pixel sees.
#pragma once

#include <cstdint>
#include <vector>

#include "tb/render/projection.h"

namespace blysk::render {

inline constexpr std::uint32_t kNoTriangle = ~std::uint32_t{0};

struct visibility {
  int width, height;
  std::vector<std::uint32_t> triangle;  ///< of each pixel, row by row; kNoTriangle: the background

  std::size_t pixels() const { return triangle.size(); }
};

/// The triangle of the mesh on the picture.
footprint footprint_of(const scene::mesh& surface, const projection& view, std::uint32_t triangle);

/// The nearest triangle of each pixel, by a z-buffer over bands of rows; of triangles equally near the first. Bands are
/// computed in `threads` threads; the result does not depend on their number.
visibility find_visible(const scene::mesh& surface, const projection& view, int width, int height,
                        unsigned threads);

/// Pixels whose centres a triangle may cover; empty if first > last.
struct box {
  int first_x, last_x, first_y, last_y;
};

/// Rays through the centres of single pixels: what find_visible() finds there.
class ray_caster {
 public:
  /// The arguments outlive it.
  ray_caster(const scene::mesh& surface, const projection& view, int width, int height);

  /// kNoTriangle: the background.
  std::uint32_t triangle_at(int x, int y) const;

 private:
  std::size_t tile_of(int pixel) const { return static_cast<std::size_t>(pixel / side_); }

  const scene::mesh& surface_;
  const projection& view_;
  std::vector<box> boxes_;
  int side_;  // of a tile, in pixels
  std::size_t tiles_across_;
  std::vector<std::vector<std::uint32_t>> of_tile_;  // triangles, in their order, whose boxes meet it
};

}  // namespace blysk::render
