// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "tb/render/segments.h"

namespace blysk::render {
namespace {

/// Pixels between four corners, these included.
struct block {
  int left, top, right, bottom;
};

class block_filling {
 public:
  block_filling(picture& image, const segments& asked)
      : image_(image), asked_(asked), is_traced_(image.rgb.size() / 3, false) {}

  segment_counts run(const tracer_of_pixels& trace) {
    std::vector<block> open = first_blocks();
    trace_all(trace);
    while (!open.empty()) {
      std::vector<block> parts;
      for (const block& each : open) {
        const bool is_small = each.right - each.left <= 1 && each.bottom - each.top <= 1;
        if (is_small || is_near(each)) {
          done_.push_back(each);
          if (!is_small && asked_.inner == inner_colours::bicubic) ask_around(each);
        } else {
          divide(each, parts);
        }
      }
      trace_all(trace);
      open.swap(parts);
    }
    for (const block& each : done_) interpolate(each);
    count();
    return counts_;
  }

 private:
  /// Begins of the blocks along a side, and its last pixel; a side of one pixel has one block of one.
  std::vector<int> places(int side) const {
    std::vector<int> all;
    for (int at = 0; at < side - 1; at += asked_.length) all.push_back(at);
    if (all.empty()) all.push_back(0);
    all.push_back(side - 1);
    return all;
  }

  std::vector<block> first_blocks() {
    const std::vector<int> columns = places(image_.width);
    const std::vector<int> rows = places(image_.height);
    std::vector<block> all;
    for (std::size_t y = 1; y < rows.size(); ++y) {
      for (std::size_t x = 1; x < columns.size(); ++x)
        add({columns[x - 1], rows[y - 1], columns[x], rows[y]}, all);
    }
    return all;
  }

  /// The corners are asked for.
  void add(const block& each, std::vector<block>& to) {
    for (const int y : {each.top, each.bottom}) {
      for (const int x : {each.left, each.right}) ask(x, y);
    }
    to.push_back(each);
  }

  /// A side of one step stays whole.
  void divide(const block& of, std::vector<block>& to) {
    const int x = (of.left + of.right) / 2;
    const int y = (of.top + of.bottom) / 2;
    const bool has_columns = of.right - of.left > 1;
    const bool has_rows = of.bottom - of.top > 1;
    const int right = has_columns ? x : of.right;
    const int bottom = has_rows ? y : of.bottom;
    add({of.left, of.top, right, bottom}, to);
    if (has_columns) add({x, of.top, of.right, bottom}, to);
    if (has_rows) add({of.left, y, right, of.bottom}, to);
    if (has_columns && has_rows) add({x, y, of.right, of.bottom}, to);
  }

  /// The grid of a bicubic block: the corners' places are the two in the middle. Nothing outside the picture.
  using places_of_grid = std::array<std::optional<int>, 4>;
  static places_of_grid grid_of(int first, int last, int side) {
    const int step = last - first;
    places_of_grid all;
    all[1] = first;
    all[2] = last;
    if (step > 0 && first - step >= 0) all[0] = first - step;
    if (step > 0 && last + step < side) all[3] = last + step;
    return all;
  }

  void ask_around(const block& of) {
    for (const std::optional<int>& y : grid_of(of.top, of.bottom, image_.height)) {
      for (const std::optional<int>& x : grid_of(of.left, of.right, image_.width)) {
        if (x && y) ask(*x, *y);
      }
    }
  }

  std::size_t number(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(x);
  }

  /// Blocks share corners.
  void ask(int x, int y) {
    if (is_traced_[number(x, y)]) return;
    is_traced_[number(x, y)] = true;
    asked_for_.push_back(static_cast<std::uint32_t>(number(x, y)));
  }

  void trace_all(const tracer_of_pixels& trace) {
    if (!asked_for_.empty()) trace(asked_for_);
    counts_.traced += asked_for_.size();
    asked_for_.clear();
  }

  /// InterpolOK of [T] fig. 2.19, of every two corners.
  bool is_near(const block& of) const {
    const std::array corners{image_.pixel(of.left, of.top), image_.pixel(of.right, of.top),
                             image_.pixel(of.left, of.bottom), image_.pixel(of.right, of.bottom)};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        if (colour_difference(asked_.measure, corners[i], corners[k]) > asked_.limit) return false;
      }
    }
    return true;
  }

  /// Calls use(x, y) for the pixels of a block that are not traced. An edge that two blocks share belongs to the one that is
  /// right of it or below.
  template <class Use>
  void for_untraced(const block& of, const Use& use) const {
    const int right = of.right == image_.width - 1 ? of.right : of.right - 1;
    const int bottom = of.bottom == image_.height - 1 ? of.bottom : of.bottom - 1;
    for (int y = of.top; y <= bottom; ++y) {
      for (int x = of.left; x <= right; ++x) {
        if (!is_traced_[number(x, y)]) use(x, y);
      }
    }
  }

  void interpolate(const block& of) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      if (asked_.inner == inner_colours::bicubic) {
        interpolate_bicubic(of, channel);
      } else {
        interpolate_bilinear(of, channel);
      }
    }
  }

  void interpolate_bilinear(const block& of, std::size_t channel) {
    const std::int64_t width = std::max(1, of.right - of.left);
    const std::int64_t height = std::max(1, of.bottom - of.top);
    const auto corner = [&](int x, int y) { return std::int64_t{image_.pixel(x, y)[channel]}; };
    const std::int64_t top_left = corner(of.left, of.top);
    const std::int64_t top_right = corner(of.right, of.top);
    const std::int64_t bottom_left = corner(of.left, of.bottom);
    const std::int64_t bottom_right = corner(of.right, of.bottom);
    for_untraced(of, [&](int x, int y) {
      const std::int64_t down = y - of.top;
      const std::int64_t along = x - of.left;
      const std::int64_t first = top_left * (height - down) + bottom_left * down;
      const std::int64_t last = top_right * (height - down) + bottom_right * down;
      const std::int64_t sum = first * (width - along) + last * along;
      image_.pixel(x, y)[channel] =
          static_cast<std::uint8_t>((2 * sum + width * height) / (2 * width * height));
    });
  }

  /// Four cubics along the rows of the grid, and one down through them.   [T] 2.6, fig. 2.18
  void interpolate_bicubic(const block& of, std::size_t channel) {
    const places_of_grid columns = grid_of(of.left, of.right, image_.width);
    const places_of_grid rows = grid_of(of.top, of.bottom, image_.height);
    for_untraced(of, [&](int x, int y) {
      std::array<double, 4> by_row{};
      for (std::size_t row = 0; row < 4; ++row) {
        if (!rows[row]) continue;
        by_row[row] = cubic_through(columns, x, [&](std::size_t column) {
          return static_cast<double>(image_.pixel(*columns[column], *rows[row])[channel]);
        });
      }
      const double value = cubic_through(rows, y, [&](std::size_t row) { return by_row[row]; });
      image_.pixel(x, y)[channel] = static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
    });
  }

  /// Through the two places in the middle of the grid; its slopes there are those between the places on either side.
  template <class Value>
  static double cubic_through(const places_of_grid& grid, int place, const Value& value_at) {
    const double left = value_at(1);
    const double right = value_at(2);
    const double length = *grid[2] - *grid[1];
    if (length == 0) return left;
    return cubic_at((place - *grid[1]) / length, left, right,
                    grid[0] ? (right - value_at(0)) / 2 : right - left,
                    grid[3] ? (value_at(3) - left) / 2 : right - left);
  }

  void count() {
    const auto width = static_cast<std::uint64_t>(image_.width);
    for (int y = 0; y < image_.height; ++y) {
      std::uint64_t inner = 0;
      for (int x = 0; x < image_.width; ++x) inner += is_traced_[number(x, y)] ? 0U : 1U;
      counts_.interpolated += inner;
      if (inner < width) counts_.elements_2_31 += elements_of_row(image_.width, inner);
    }
    const auto between = static_cast<std::uint64_t>(asked_.length - 1);
    counts_.elements_2_29 = elements_of_row(image_.width, between) * elements_of_row(image_.height, between);
  }

  picture& image_;
  const segments& asked_;
  std::vector<bool> is_traced_;
  std::vector<std::uint32_t> asked_for_;
  std::vector<block> done_;
  segment_counts counts_;
};

}  // namespace

segment_counts fill_by_blocks(picture& image, const segments& asked, const tracer_of_pixels& trace) {
  if (asked.inner != inner_colours::bilinear && asked.inner != inner_colours::bicubic)
    throw std::logic_error("a block has four corners, expected inner colours of blocks");
  return block_filling(image, asked).run(trace);
}

}  // namespace blysk::render
