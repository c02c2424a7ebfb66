// SPDX-License-Identifier: Apache-2.0
#include "tb/render/picture.h"

#include <png.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace blysk::render {

void paste(const picture& tile, picture& sheet, int x, int y) {
  for (int row = 0; row < tile.height; ++row) {
    std::copy_n(tile.pixel(0, row), 3 * tile.width, sheet.pixel(x, y + row));
  }
}

picture difference(const picture& a, const picture& b, int gain) {
  picture result(a.width, a.height);
  std::transform(a.rgb.begin(), a.rgb.end(), b.rgb.begin(), result.rgb.begin(), [gain](int p, int q) {
    return static_cast<std::uint8_t>(std::min(255, gain * std::abs(p - q)));
  });
  return result;
}

std::string png_of(const picture& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) == 0) {
    throw std::runtime_error(std::string("a picture cannot be made: ") + png.message);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace blysk::render
