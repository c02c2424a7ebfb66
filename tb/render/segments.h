// SPDX-License-Identifier: Apache-2.0
/// Segments of rows, [T] 2.6: the two ends of a segment are traced; if their colours are near to each other, the pixels
/// between them are interpolated, else the segment is halved. Blocks of pixels are the same in both directions.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "tb/render/picture.h"

namespace blysk::render {

/// How far two colours are from each other. [T] states 2.3 and no measure: it is the just noticeable difference of CIE76.
enum class colour_measure {
  cie76,  ///< distance in CIELAB of sRGB, white D65: 100 from black to white
  rgb     ///< distance of the codes 0..255
};

/// Of the pixels inside a segment.   [T] fig. 2.18
enum class inner_colours {
  mean,    ///< half the sum of the ends, (2.27)
  linear,  ///< in proportion to the distances
  cubic,  ///< through the ends, with the slopes that the next traced pixels on either side give (Catmull, Rom 1974)
  bilinear,  ///< of blocks, as many rows as pixels: in proportion to the distances from the four corners
  bicubic    ///< of blocks: cubic in both directions, from 16 traced pixels of a grid
};

struct named_inner_colours {
  inner_colours are;
  std::string_view name;
  bool are_of_blocks;
};
inline constexpr std::array kInnerColours{named_inner_colours{inner_colours::mean, "mean", false},
                                          named_inner_colours{inner_colours::linear, "linear", false},
                                          named_inner_colours{inner_colours::cubic, "cubic", false},
                                          named_inner_colours{inner_colours::bilinear, "bilinear", true},
                                          named_inner_colours{inner_colours::bicubic, "bicubic", true}};

struct segments {
  int length =
      8;  ///< pixels from one end to the other, 1 and up: one traced, length - 1 between; of a block on each side
  double limit = 2.3;  ///< K: the largest difference that is interpolated
  colour_measure measure = colour_measure::cie76;
  inner_colours inner = inner_colours::mean;
};

struct segment_counts {
  std::uint64_t traced = 0;        ///< pixels
  std::uint64_t interpolated = 0;  ///< all others
  std::uint64_t elements_2_29 =
      0;  ///< processing elements of a picture with segments of one length, (2.28) (2.29); of blocks by (2.28) in both directions
  std::uint64_t elements_2_31 =
      0;  ///< the same by (2.31), with the row's segments as they came out; of blocks, the rows with a traced pixel
};

/// [T] (2.28) and (2.31) for a row of `width` pixels.
/// \param inner  pixels inside a segment; for (2.31) inside all segments of the row
std::uint64_t elements_of_row(int width, std::uint64_t inner);

double colour_difference(colour_measure by, const std::uint8_t* a, const std::uint8_t* b);

/// Writes the colours of these pixels, numbered row by row; each is asked for once.
using tracer_of_pixels = std::function<void(std::span<const std::uint32_t>)>;

/// The cubic polynomial of t in [0, 1] with these values and slopes at its ends.   Hermite
constexpr double cubic_at(double t, double left, double right, double left_slope, double right_slope) {
  return left * (1 + 2 * t) * (1 - t) * (1 - t) + right * t * t * (3 - 2 * t) +
         left_slope * t * (1 - t) * (1 - t) - right_slope * t * t * (1 - t);
}

/// Fills a picture.
/// \throws std::logic_error for inner colours of blocks
segment_counts fill_by_segments(picture& image, const segments& asked, const tracer_of_pixels& trace);

/// The same by blocks, for inner colours of blocks: the four corners of a block are traced; if every two of them are near to each
/// other, the other pixels are interpolated, else the block is halved in both directions. For bicubic the twelve pixels around
/// the corners are traced, too, which are as far from them as the corners are from each other; where one lies outside the picture,
/// the slope there is that between the corners.
/// \throws std::logic_error for inner colours of segments
segment_counts fill_by_blocks(picture& image, const segments& asked, const tracer_of_pixels& trace);

}  // namespace blysk::render
