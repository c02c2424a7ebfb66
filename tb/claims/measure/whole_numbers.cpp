// SPDX-License-Identifier: Apache-2.0
// [T] 2.4 and 2.6: division by shifts, what a triangle costs, processing elements.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "tb/claims/figure.h"
#include "tb/golden/shift_division.h"

namespace blysk::claims {

using namespace golden;

namespace {

struct lattice_point {
  int x, y;
};

using lattice_triangle = std::array<lattice_point, 3>;

struct lattice_count {
  int inside = 0;
  int on_edge = 0;     ///< corners included
  int widest_row = 0;  ///< points of a row, edges included
};

/// Looks at every point of a square that holds the triangle.
lattice_count points_inside(const lattice_triangle& triangle) {
  constexpr int kReach = 32;
  lattice_count result;
  for (int y = -kReach; y <= kReach; ++y) {
    int row = 0;
    for (int x = -kReach; x <= kReach; ++x) {
      std::array<int, 3> sides{};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& a = triangle[i];
        const auto& b = triangle[(i + 1) % 3];
        sides[i] = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
      }
      const auto [least, most] = std::ranges::minmax(sides);
      if (least < 0 && most > 0) continue;
      ++row;
      ++(least == 0 || most == 0 ? result.on_edge : result.inside);
    }
    result.widest_row = std::max(result.widest_row, row);
  }
  return result;
}

/// How many pixels of a row are traced, if every segment has `inner` pixels between its ends; the last may be shorter.
int traced_pixels(int row, int inner) {
  int traced = 1;  // the row's first pixel
  for (int x = 0; x < row - 1; x = std::min(x + inner + 1, row - 1)) ++traced;
  return traced;
}

figures segment_tracing() {
  constexpr int kRows = 2048;
  constexpr int kInner = 64;
  int exact = 0;
  int one_more = 0;
  int rows = 0;
  int off = 0;      // (2.28), in pixels
  int most = 0;     // elements by (2.31), rows that whole segments fill
  int off_231 = 0;  // (2.31), in pixels
  for (int inner = 1; inner <= kInner; ++inner) {
    for (int row = 2; row <= kRows; ++row, ++rows) {
      const int by_2_28 = static_cast<int>(std::ceil(static_cast<double>(row) / (inner + 1) + 1));
      const int traced = traced_pixels(row, inner);
      exact += by_2_28 == traced;
      one_more += by_2_28 == traced + 1;
      off = std::max(off, std::abs(by_2_28 - traced));
      if ((row - 1) % (inner + 1) != 0) continue;
      const int segments = (row - 1) / (inner + 1);
      for (const int sum : {segments * inner + 1, segments * (inner + 1)}) {
        const int by_2_31 = static_cast<int>(std::ceil(static_cast<double>(row) / sum)) + 1;
        most = std::max(most, by_2_31);
        off_231 = std::max(off_231, std::abs(by_2_31 - traced));
      }
    }
  }
  return {{"exact", 100.0 * exact / rows},
          {"one_more", 100.0 * one_more / rows},
          {"off", static_cast<double>(off)},
          {"most", static_cast<double>(most)},
          {"off_231", static_cast<double>(off_231)}};
}

/// Largest absolute error, largest relative and mean relative error of 255/k by shifts, k = first..16.
struct shift_errors {
  double largest = 0;
  double largest_relative = 0;
  double mean = 0;
};

shift_errors errors_of_shifts(int first, int places) {
  shift_errors result;
  for (int k = first; k <= 16; ++k) {
    const double error = std::abs(255.0 / k - shifted_quotient(255, static_cast<uint32_t>(k), places));
    result.largest = std::max(result.largest, error);
    result.largest_relative = std::max(result.largest_relative, error * k / 255);
    result.mean += error * k / 255 / (17 - first);
  }
  return result;
}

/// The triangle of table 2.1.
constexpr lattice_triangle kExample{lattice_point{0, 0}, lattice_point{7, 8}, lattice_point{-9, 12}};

constexpr int kSums = 18 + 99 + 66 + 225;
constexpr int kDivisions = 9 + 33;

/// Whole numbers of cycles for a sum and a division that give so many in all: "3 and 41".
std::string prices(int cycles) {
  std::string result;
  for (int sum = 1; sum * kSums < cycles; ++sum) {
    const int rest = cycles - sum * kSums;
    if (rest % kDivisions != 0) continue;
    if (!result.empty()) result += " or ";
    result += fmt::format("{} and {}", sum, rest / kDivisions);
  }
  return result;
}

}  // namespace

void measure_whole_numbers(measurements& into) {
  into["T22"] = [] {
    return figures{{"exact", 255.0 / 7},
                   {"shifted", shifted_quotient(255, 7, 6)},
                   {"digits", static_cast<double>(reciprocal_digits(7, 6))}};
  };
  into["T23"] = [] {
    const double error = 255.0 / 7 - shifted_quotient(255, 7, 6);
    return figures{{"error", error}, {"relative", 100 * error / (255.0 / 7)}};
  };
  into["T24"] = [] {
    const auto errors = errors_of_shifts(2, 8);
    return figures{{"largest", errors.largest},
                   {"mean", 100 * errors.mean},
                   {"mean_from_3", 100 * errors_of_shifts(3, 8).mean}};
  };
  into["T46"] = [] {
    figures result;
    for (const int places : {6, 7, 8}) {
      const auto errors = errors_of_shifts(2, places);
      const std::string key = fmt::format("s{}", places);
      result[key] = 100 * errors.largest_relative;
      result[key + "_mean"] = 100 * errors.mean;
    }
    return result;
  };
  into["T25"] = [] {
    const int inner_rows = 12 - 0 - 1;  // of the triangle's height
    const int edge_points = 3 * ((std::max(7, 8) - 1) + (std::max(9, 12) - 1) + (std::max(16, 4) - 1));
    return figures{{"sums", static_cast<double>(kSums)},
                   {"divisions", static_cast<double>(kDivisions)},
                   {"edges", static_cast<double>(edge_points)},
                   {"row_divisions", 3.0 * inner_rows},
                   {"row_sums", 6.0 * inner_rows}};
  };
  into["T26"] = [] {
    const auto count = points_inside(kExample);
    return figures{{"inside", static_cast<double>(count.inside)},
                   {"sums", 3.0 * count.inside},
                   {"on_edge", static_cast<double>(count.on_edge)}};
  };
  into["T41"] = [] { return figures{{"widest", static_cast<double>(points_inside(kExample).widest_row)}}; };
  into["T27"] = [] {
    const int by_shifts =
        9;  // clocks of the devices in q8, as unit.shift-divider and unit.restoring-divider count them
    const int restoring = 17;
    const double clocks = (408.0 + 42 * restoring) / (408 + 42 * by_shifts);
    return figures{
        {"ratio", 2946.0 / 2064}, {"first", prices(2946)}, {"second", prices(2064)}, {"clocks", clocks}};
  };
  into["T39"] = segment_tracing;
  into["E14"] = [] { return figures{{"digits", static_cast<double>(reciprocal_digits(1, 8))}}; };
}

}  // namespace blysk::claims
