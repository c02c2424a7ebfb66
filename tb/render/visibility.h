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

}  // namespace blysk::render
