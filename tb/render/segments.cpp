// SPDX-License-Identifier: Apache-2.0
#include "tb/render/segments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace blysk::render {
namespace {

using lab = std::array<double, 3>;

/// CIELAB of an sRGB colour (IEC 61966-2-1), white D65.
lab lab_of(const std::uint8_t* rgb) {
  std::array<double, 3> linear{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double code = rgb[i] / 255.0;
    linear[i] = code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
  }
  const auto [r, g, b] = linear;
  const auto f = [](double share) {
    constexpr double kLinearBelow = 216.0 / 24389;
    return share > kLinearBelow ? std::cbrt(share) : (24389.0 / 27 * share + 16) / 116;
  };
  const double x = f((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
  const double y = f(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
  const double z = f((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

struct segment {
  int row, left, right;
};

class segment_filling {
 public:
  segment_filling(picture& image, const segments& asked) : image_(image), asked_(asked) {}

  segment_counts run(const tracer_of_pixels& trace) {
    std::vector<segment> open = first_segments();
    trace_all(trace);
    while (!open.empty()) {
      std::vector<segment> halves;
      for (const segment& each : open) {
        if (each.right - each.left <= 1 || is_near(each)) {
          done_.push_back(each);
          continue;
        }
        const int middle = (each.left + each.right) / 2;
        ask(each.row, middle);
        halves.push_back({each.row, each.left, middle});
        halves.push_back({each.row, middle, each.right});
      }
      trace_all(trace);
      open.swap(halves);
    }
    std::ranges::sort(done_, {}, [](const segment& of) { return std::pair{of.row, of.left}; });
    for (std::size_t i = 0; i < done_.size(); ++i) interpolate(i);
    count();
    return counts_;
  }

 private:
  std::vector<segment> first_segments() {
    std::vector<segment> all;
    for (int row = 0; row < image_.height; ++row) {
      ask(row, 0);
      for (int left = 0; left < image_.width - 1; left = all.back().right) {
        all.push_back({row, left, std::min(left + asked_.length, image_.width - 1)});
        ask(row, all.back().right);
      }
    }
    return all;
  }

  void ask(int row, int x) { asked_for_.push_back(static_cast<std::uint32_t>(row * image_.width + x)); }

  void trace_all(const tracer_of_pixels& trace) {
    if (!asked_for_.empty()) trace(asked_for_);
    counts_.traced += asked_for_.size();
    asked_for_.clear();
  }

  /// InterpolOK of [T] fig. 2.19.
  bool is_near(const segment& of) const {
    return colour_difference(asked_.measure, image_.pixel(of.left, of.row), image_.pixel(of.right, of.row)) <=
           asked_.limit;
  }

  void interpolate(std::size_t index) {
    const segment& of = done_[index];
    const bool follows = index > 0 && done_[index - 1].row == of.row;
    const bool is_followed = index + 1 < done_.size() && done_[index + 1].row == of.row;
    const int before = follows ? done_[index - 1].left : of.left;
    const int behind = is_followed ? done_[index + 1].right : of.right;
    const double length = of.right - of.left;
    counts_.interpolated += static_cast<std::uint64_t>(of.right - of.left - 1);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const auto at = [&](int x) { return static_cast<double>(image_.pixel(x, of.row)[channel]); };
      const double left = at(of.left);
      const double right = at(of.right);
      const double left_slope = (right - at(before)) / (of.right - before) * length;
      const double right_slope = (at(behind) - left) / (behind - of.left) * length;
      for (int x = of.left + 1; x < of.right; ++x) {
        const double t = (x - of.left) / length;
        double value = 0;
        switch (asked_.inner) {
          case inner_colours::mean:
            value = (left + right) / 2;
            break;
          case inner_colours::linear:
            value = left + t * (right - left);
            break;
          case inner_colours::cubic:
            value = cubic_at(t, left, right, left_slope, right_slope);
            break;
          case inner_colours::bilinear:
          case inner_colours::bicubic:
            throw std::logic_error("a segment has two ends, expected a block");
        }
        image_.pixel(x, of.row)[channel] =
            static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
      }
    }
  }

  void count() {
    std::vector<std::uint64_t> inner(static_cast<std::size_t>(image_.height), 0);
    for (const segment& each : done_)
      inner[static_cast<std::size_t>(each.row)] += static_cast<std::uint64_t>(each.right - each.left - 1);
    for (const std::uint64_t each : inner) {
      counts_.elements_2_29 += elements_of_row(image_.width, static_cast<std::uint64_t>(asked_.length - 1));
      counts_.elements_2_31 += elements_of_row(image_.width, each);
    }
  }

  picture& image_;
  const segments& asked_;
  std::vector<std::uint32_t> asked_for_;
  std::vector<segment> done_;
  segment_counts counts_;
};

}  // namespace

double colour_difference(colour_measure by, const std::uint8_t* a, const std::uint8_t* b) {
  if (std::equal(a, a + 3, b)) return 0;
  const auto distance = [](const auto& from, const auto& to) {
    return std::hypot(static_cast<double>(from[0]) - to[0], static_cast<double>(from[1]) - to[1],
                      static_cast<double>(from[2]) - to[2]);
  };
  return by == colour_measure::rgb ? distance(a, b) : distance(lab_of(a), lab_of(b));
}

std::uint64_t elements_of_row(int width, std::uint64_t inner) {
  return (static_cast<std::uint64_t>(width) + inner) / (inner + 1) + 1;
}

segment_counts fill_by_segments(picture& image, const segments& asked, const tracer_of_pixels& trace) {
  return segment_filling(image, asked).run(trace);
}

}  // namespace blysk::render
