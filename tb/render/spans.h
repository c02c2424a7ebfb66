// SPDX-License-Identifier: Apache-2.0
/// Rows of pixels within a triangle through a device that draws lines between two colours, [T] 2.4, in the place of Gouraud's
/// interpolation on the host.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tb/device.h"
#include "tb/engine.h"
#include "tb/render/attached_device.h"
#include "tb/render/picture.h"

namespace blysk::render {

/// The device of the list that draws lines: the one with columns for their two colours.
/// \throws std::logic_error if there is none
selection choose_span_device(const std::string& format);

/// Collects lines, draws them, and puts them into a picture.
class span_drawer {
 public:
  using colour = std::array<std::uint8_t, 3>;
  static constexpr int kMostPixels = 1024;  ///< of a line

  span_drawer(const attached_device& from, picture& to);

  /// A line from (left, row) to (right, row), both included: 2 to kMostPixels pixels.
  void add(int row, int left, int right, const colour& first, const colour& last);

  /// Draws what waits; after the last line.
  void run();

  std::uint64_t lines() const { return drawn_; }
  double seconds() const { return seconds_; }

 private:
  struct line {
    int row, left, right;
    colour first, last;
  };
  static constexpr std::size_t kBatch = 4096;

  engine& through_;
  picture& to_;
  std::vector<line> lines_;
  columns inputs_, outputs_;
  std::uint64_t drawn_ = 0;
  double seconds_ = 0;
};

}  // namespace blysk::render
