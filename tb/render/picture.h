// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace blysk::render {

/// RGB picture, 8 bits a channel, row by row from the top, 3 bytes a pixel.
struct picture {
  picture(int wide, int high)
      : width(wide), height(high), rgb(3 * static_cast<std::size_t>(wide) * static_cast<std::size_t>(high)) {}

  std::uint8_t* pixel(int x, int y) {
    return rgb.data() +
           3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }
  const std::uint8_t* pixel(int x, int y) const { return const_cast<picture*>(this)->pixel(x, y); }

  int width, height;
  std::vector<std::uint8_t> rgb;
};

/// Copies `tile` into `sheet`, its upper left corner at (x, y); it has to lie inside.
void paste(const picture& tile, picture& sheet, int x, int y);

/// |a - b| per channel, `gain` times, at most 255. Both pictures have the same size.
picture difference(const picture& a, const picture& b, int gain);

/// The bytes of a PNG file.
/// \throws std::runtime_error with libpng's reason
std::string png_of(const picture& image);

}  // namespace blysk::render
