// SPDX-License-Identifier: Apache-2.0
// Segments of rows: which pixels are traced, what the others become, and rays against the z-buffer.
#include "tb/render/segments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tb/catch.h"
#include "tb/render/test/picture_source.h"
#include "tb/render/test/random_scene.h"
#include "tb/scene/shapes.h"

namespace {

using namespace blysk;
using namespace blysk::render;

bool is_of_blocks(inner_colours which) {
  return which == inner_colours::bilinear || which == inner_colours::bicubic;
}

struct filled {
  picture image;
  std::vector<int> times_traced;
  segment_counts counts;
};

filled fill_from(const picture& whole, const segments& asked) {
  filled made{picture(whole.width, whole.height), std::vector<int>(whole.rgb.size() / 3, 0), {}};
  const auto fill = is_of_blocks(asked.inner) ? fill_by_blocks : fill_by_segments;
  made.counts = fill(made.image, asked, [&](std::span<const std::uint32_t> pixels) {
    for (const std::uint32_t each : pixels) {
      ++made.times_traced[each];
      std::copy_n(whole.rgb.begin() + 3 * each, 3, made.image.rgb.begin() + 3 * each);
    }
  });
  return made;
}

/// No channel is further from its exact value, cut to 0..255, than rounding makes it.
void require_rounded(const picture& made, const std::vector<double>& exact) {
  REQUIRE(made.rgb.size() == exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (std::abs(made.rgb[i] - std::clamp(exact[i], 0.0, 255.0)) > 0.5 + 1e-9)
      FAIL("channel " << i << " is " << int{made.rgb[i]} << ", expected " << exact[i]);
  }
}

picture noise(int width, int height, int step) {
  std::mt19937_64 bits(static_cast<std::uint64_t>(width * 1000 + height));
  picture made(width, height);
  for (std::uint8_t& each : made.rgb)
    each = static_cast<std::uint8_t>(static_cast<std::uint64_t>(step) * (bits() % 3));
  return made;
}

TEST_CASE("colours differ by what CIE76 says", "[render][segments]") {
  const std::array<std::uint8_t, 3> black{0, 0, 0};
  const std::array<std::uint8_t, 3> white{255, 255, 255};
  const std::array<std::uint8_t, 3> red{255, 0, 0};
  const std::array<std::uint8_t, 3> green{0, 255, 0};
  const auto cie = [](const auto& a, const auto& b) {
    return colour_difference(colour_measure::cie76, a.data(), b.data());
  };
  CHECK(cie(black, white) == Approx(100).epsilon(1e-4));
  // CIELAB of sRGB's red and green: (53.24, 80.09, 67.20), (87.73, -86.18, 83.18).
  CHECK(cie(black, red) == Approx(std::sqrt(53.24 * 53.24 + 80.09 * 80.09 + 67.20 * 67.20)).epsilon(1e-3));
  CHECK(cie(red, green) == Approx(std::sqrt(34.49 * 34.49 + 166.27 * 166.27 + 15.98 * 15.98)).epsilon(1e-3));
  CHECK(cie(red, red) == 0);
  CHECK(cie(red, green) == cie(green, red));
  CHECK(colour_difference(colour_measure::rgb, red.data(), green.data()) == Approx(255 * std::sqrt(2)));
}

TEST_CASE("with no limit the ends alone are traced, as many as (2.28) says", "[render][segments]") {
  for (const int width : {1, 2, 7, 8, 9, 16, 17, 100, 512}) {
    for (const int length : {1, 2, 5, 8, 64, 1000}) {
      const picture whole = noise(width, 3, 80);
      const filled made =
          fill_from(whole, {.length = length, .limit = std::numeric_limits<double>::infinity()});
      CAPTURE(width, length);
      std::uint64_t traced = 0;
      for (int x = 0; x < width; ++x) {
        const bool is_end = x % length == 0 || x == width - 1;
        traced += is_end ? 1U : 0U;
        for (int y = 0; y < 3; ++y)
          REQUIRE(made.times_traced[static_cast<std::size_t>(y * width + x)] == (is_end ? 1 : 0));
      }
      CHECK(made.counts.traced == 3 * traced);
      CHECK(made.counts.traced + made.counts.interpolated == 3 * static_cast<std::uint64_t>(width));
      // ceil(X / (L + 1)) + 1 with L = length - 1 between the ends: one too many where the last end is the row's last.
      const auto rows = static_cast<std::uint64_t>(std::ceil(static_cast<double>(width) / length)) + 1;
      CHECK(made.counts.elements_2_29 == 3 * rows);
      CHECK(rows - traced <= 1);
    }
  }
}

TEST_CASE("a segment is interpolated only if its ends are alike", "[render][segments]") {
  const picture whole = noise(200, 20, 3);
  std::uint64_t before = std::numeric_limits<std::uint64_t>::max();
  for (const double limit : {0.0, 1.0, 2.3, 4.0, 100.0}) {
    const filled made = fill_from(whole, {.length = 16, .limit = limit});
    CHECK(made.counts.traced <= before);
    before = made.counts.traced;
    CHECK(*std::ranges::max_element(made.times_traced) == 1);
    for (int y = 0; y < 20; ++y) {
      int left = 0;
      for (int x = 1; x < 200; ++x) {
        if (made.times_traced[static_cast<std::size_t>(200 * y + x)] == 0) continue;
        const double off = colour_difference(colour_measure::cie76, whole.pixel(left, y), whole.pixel(x, y));
        CAPTURE(limit, y, left, x);
        if (x - left > 1) REQUIRE(off <= limit);
        for (int inner = left + 1; inner < x; ++inner) {
          for (std::size_t channel = 0; channel < 3; ++channel) {
            const int sum = whole.pixel(left, y)[channel] + whole.pixel(x, y)[channel];
            REQUIRE(made.image.pixel(inner, y)[channel] == (sum + 1) / 2);
          }
        }
        left = x;
      }
    }
  }
}

TEST_CASE("linear and cubic segments follow lines and parabolas", "[render][segments]") {
  picture line(65, 1);
  picture curve(65, 1);
  for (int x = 0; x < 65; ++x) {
    line.pixel(x, 0)[0] = static_cast<std::uint8_t>(10 + 3 * x);
    curve.pixel(x, 0)[1] = static_cast<std::uint8_t>(std::lround((x - 32) * (x - 32) / 4.2));
  }
  const auto error_of = [](const picture& whole, inner_colours inner) {
    const filled made = fill_from(whole, {.length = 16, .limit = 1000, .inner = inner});
    int worst = 0;
    for (std::size_t i = 0; i < whole.rgb.size(); ++i)
      worst = std::max(worst, std::abs(whole.rgb[i] - made.image.rgb[i]));
    return worst;
  };
  CHECK(error_of(line, inner_colours::linear) == 0);
  CHECK(error_of(line, inner_colours::cubic) == 0);
  CHECK(error_of(line, inner_colours::mean) == 21);  // 7 pixels of 3 each away from the middle
  // Of a parabola with the second derivative 2 / 4.2 a line of 16 pixels misses 16^2 / (4 * 4.2) in its middle. The cubic
  // is exact between two other segments; at the row's ends its slope there is that of the line.
  CHECK(error_of(curve, inner_colours::linear) == Approx(256 / (4 * 4.2)).margin(1));
  CHECK(error_of(curve, inner_colours::cubic) < error_of(curve, inner_colours::linear) / 1.5);
}

/// Rows depth first, by the definition: what is traced, and the colours before they are rounded.
class rows_by_definition {
 public:
  rows_by_definition(const picture& whole, const segments& asked)
      : whole_(whole), asked_(asked), exact(whole.rgb.begin(), whole.rgb.end()) {
    times_traced.resize(whole.rgb.size() / 3);
    for (row_ = 0; row_ < whole.height; ++row_) {
      ends_ = {0};
      trace(0);
      for (int left = 0; left < whole.width - 1; left += asked.length)
        divide(left, std::min(left + asked.length, whole.width - 1));
      for (std::size_t i = 0; i + 1 < ends_.size(); ++i) fill(i);
    }
  }

 private:
  const picture& whole_;
  const segments& asked_;

 public:
  std::vector<double> exact;
  std::vector<int> times_traced;

 private:
  void trace(int x) { times_traced[static_cast<std::size_t>(row_ * whole_.width + x)] = 1; }

  void divide(int left, int right) {
    const bool is_near = colour_difference(asked_.measure, whole_.pixel(left, row_),
                                           whole_.pixel(right, row_)) <= asked_.limit;
    trace(right);
    if (right - left <= 1 || is_near) {
      ends_.push_back(right);
    } else {
      divide(left, (left + right) / 2);
      divide((left + right) / 2, right);
    }
  }

  void fill(std::size_t piece) {
    const double left = ends_[piece];
    const double right = ends_[piece + 1];
    const int before = ends_[piece > 0 ? piece - 1 : piece];
    const int behind = ends_[std::min(piece + 2, ends_.size() - 1)];
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const auto colour = [&](int x) { return static_cast<double>(whole_.pixel(x, row_)[channel]); };
      const double a = colour(ends_[piece]);
      const double b = colour(ends_[piece + 1]);
      // Newton's polynomial through both ends, each twice.
      const double slope = (b - a) / (right - left);
      const double left_slope = (b - colour(before)) / (right - before);
      const double right_slope = (colour(behind) - a) / (behind - left);
      const double second = (slope - left_slope) / (right - left);
      const double third = (left_slope - 2 * slope + right_slope) / ((right - left) * (right - left));
      for (int x = ends_[piece] + 1; x < ends_[piece + 1]; ++x) {
        const double from_left = x - left;
        exact[3 * static_cast<std::size_t>(row_ * whole_.width + x) + channel] =
            asked_.inner == inner_colours::mean ? (a + b) / 2
            : asked_.inner == inner_colours::linear
                ? a + slope * from_left
                : a + left_slope * from_left + (second + third * (x - right)) * from_left * from_left;
      }
    }
  }

  int row_ = 0;
  std::vector<int> ends_;  // of the row's pieces
};

TEST_CASE("segments are what their definition says, pixel by pixel", "[render][segments]") {
  for (const int width : {1, 2, 9, 40, 65}) {
    for (const int length : {1, 3, 8, 64}) {
      for (const double limit : {0.0, 2.3, 5.0, 1000.0}) {
        for (const inner_colours inner : {inner_colours::mean, inner_colours::linear, inner_colours::cubic}) {
          const picture whole = noise(width, 7, limit > 500 ? 120 : 3);
          const segments asked{.length = length, .limit = limit, .inner = inner};
          const filled made = fill_from(whole, asked);
          const rows_by_definition expected(whole, asked);
          CAPTURE(width, length, limit, static_cast<int>(inner));
          REQUIRE(made.times_traced == expected.times_traced);
          require_rounded(made.image, expected.exact);
          std::uint64_t elements = 0;
          for (int y = 0; y < whole.height; ++y) {
            const auto row = made.times_traced.begin() + std::ptrdiff_t{y} * width;
            const auto inside = static_cast<double>(std::count(row, row + width, 0));
            elements += static_cast<std::uint64_t>(std::ceil(width / (inside + 1))) + 1;
          }
          REQUIRE(made.counts.elements_2_31 == elements);
        }
      }
    }
  }
}

TEST_CASE("rays at every pixel give the picture of the z-buffer", "[render][segments]") {
  const test::picture_source from(choose(devices().front()->name(), "q12"), false);
  std::uint64_t traced = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    test::scene_maker maker(seed);
    const scene::world of = maker.make();
    job asked{.of = &of,
              .width = 23,
              .height = 17,
              .shading = &find_shading("phong"),
              .is_corrected = seed % 2 == 0,
              .device = from.of()};
    const outcome whole = render::render(asked);
    asked.by_segments = segments{.length = 1};
    const outcome rays = render::render(asked);
    CAPTURE(seed);
    REQUIRE(rays.image.rgb == whole.image.rgb);
    REQUIRE(rays.reference.rgb == whole.reference.rgb);
    REQUIRE(rays.device_writes == whole.device_writes);
    REQUIRE(rays.by_segments->traced == 23 * 17);
    REQUIRE(rays.points == whole.points);
    asked.by_segments = segments{.length = 1, .inner = inner_colours::bilinear};
    REQUIRE(render::render(asked).image.rgb == whole.image.rgb);
    asked.by_segments = segments{};
    if (seed % 4 < 2)
      asked.by_segments->inner = seed % 8 < 4 ? inner_colours::bilinear : inner_colours::bicubic;
    asked.threads = 3;
    const outcome some = render::render(asked);
    asked.threads = 1;
    asked.asked = effects::all;
    REQUIRE(render::render(asked).image.rgb == some.image.rgb);
    REQUIRE(some.by_segments->traced >= some.points);
    traced += some.by_segments->traced;
  }
  CHECK(traced < 200 * 23 * 17);
}

TEST_CASE("segments spare rays where a picture is smooth", "[render][segments]") {
  scene::world of;
  of.surface = scene::make_sphere(32);
  const test::picture_source from(choose(devices().front()->name(), "q12"), false);
  job asked{.of = &of, .width = 256, .height = 256, .shading = &find_shading("phong"), .device = from.of()};
  asked.by_segments = segments{};
  const outcome some = render::render(asked);
  CHECK(some.by_segments->traced < 256 * 256 / 2);
  CHECK(some.device_writes < some.points);
  asked.shading = &find_shading("gouraud");
  CHECK_THROWS_AS(render::render(asked), std::invalid_argument);
}

TEST_CASE("a scene is filled by the interpolation that is asked for", "[render][segments]") {
  scene::world of;
  of.surface = scene::make_sphere(12);
  const test::picture_source from(choose(devices().front()->name(), "q12"), false);
  job asked{.of = &of, .width = 61, .height = 47, .shading = &find_shading("phong"), .device = from.of()};
  const picture whole = render::render(asked).image;
  std::vector<picture> all;
  for (const named_inner_colours& each : kInnerColours) {
    asked.by_segments = segments{.length = 8, .limit = 10, .inner = each.are};
    const outcome made = render::render(asked);
    const filled expected = fill_from(whole, *asked.by_segments);
    CAPTURE(each.name);
    CHECK(made.image.rgb == expected.image.rgb);
    CHECK(made.by_segments->traced == expected.counts.traced);
    CHECK(made.by_segments->interpolated == expected.counts.interpolated);
    for (const picture& other : all) CHECK(made.image.rgb != other.rgb);
    all.push_back(made.image);
  }
  picture wrong(8, 8);
  CHECK_THROWS_AS(fill_by_blocks(wrong, segments{}, [](auto) {}), std::logic_error);
  CHECK_THROWS_AS(fill_by_segments(wrong, segments{.inner = inner_colours::bicubic}, [](auto) {}),
                  std::logic_error);
}

/// Blocks depth first, by the definition: what is traced, and the colours before they are rounded.
class blocks_by_definition {
 public:
  blocks_by_definition(const picture& whole, const segments& asked)
      : whole_(whole), asked_(asked), exact(whole.rgb.size(), 0), times_traced(whole.rgb.size() / 3, 0) {
    std::vector<int> columns{0}, rows{0};
    while (columns.back() + asked.length < whole.width - 1) columns.push_back(columns.back() + asked.length);
    while (rows.back() + asked.length < whole.height - 1) rows.push_back(rows.back() + asked.length);
    for (std::size_t y = 0; y < rows.size(); ++y) {
      for (std::size_t x = 0; x < columns.size(); ++x) {
        fill(columns[x], rows[y], x + 1 < columns.size() ? columns[x + 1] : whole.width - 1,
             y + 1 < rows.size() ? rows[y + 1] : whole.height - 1);
      }
    }
    for (std::size_t i = 0; i < exact.size(); ++i) {
      if (times_traced[i / 3] != 0) exact[i] = whole.rgb[i];
    }
  }

 private:
  const picture& whole_;
  const segments& asked_;

 public:
  std::vector<double> exact;
  std::vector<int> times_traced;

 private:
  void fill(int left, int top, int right, int bottom) {
    const std::array xs{left, right, left, right};
    const std::array ys{top, top, bottom, bottom};
    double most = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      times_traced[static_cast<std::size_t>(ys[i] * whole_.width + xs[i])] = 1;
      for (std::size_t k = 0; k < 4; ++k)
        most = std::max(
            most, colour_difference(asked_.measure, whole_.pixel(xs[i], ys[i]), whole_.pixel(xs[k], ys[k])));
    }
    const bool is_small = right - left <= 1 && bottom - top <= 1;
    if (most <= asked_.limit || is_small) {
      for (int y = top; y <= bottom; ++y) {
        for (int x = left; x <= right; ++x) {
          const bool is_of_next =
              (x == right && x != whole_.width - 1) || (y == bottom && y != whole_.height - 1);
          if (is_of_next) continue;
          const double across = right > left ? static_cast<double>(x - left) / (right - left) : 0;
          const double down = bottom > top ? static_cast<double>(y - top) / (bottom - top) : 0;
          for (std::size_t channel = 0; channel < 3; ++channel) {
            const auto index = static_cast<std::size_t>(y * whole_.width + x);
            exact[3 * index + channel] = value_at(left, top, right, bottom, across, down, channel);
          }
        }
      }
      if (is_small || asked_.inner != inner_colours::bicubic) return;
      for (int j = -1; j <= 2; ++j) {
        for (int i = -1; i <= 2; ++i) {
          const int x = left + i * (right - left);
          const int y = top + j * (bottom - top);
          if (is_inside(x, y)) times_traced[static_cast<std::size_t>(y * whole_.width + x)] = 1;
        }
      }
      return;
    }
    const int x = right - left > 1 ? (left + right) / 2 : right;
    const int y = bottom - top > 1 ? (top + bottom) / 2 : bottom;
    fill(left, top, x, y);
    if (x < right) fill(x, top, right, y);
    if (y < bottom) fill(left, y, x, bottom);
    if (x < right && y < bottom) fill(x, y, right, bottom);
  }

  bool is_inside(int x, int y) const { return x >= 0 && x < whole_.width && y >= 0 && y < whole_.height; }

  /// A sum over the pixels of the grid, weighted by their distances in units of its step.
  double value_at(int left, int top, int right, int bottom, double across, double down,
                  std::size_t channel) const {
    const bool is_bicubic = asked_.inner == inner_colours::bicubic;
    const auto weight = [&](double distance) {
      return is_bicubic ? keys(distance) : std::max(0.0, 1 - distance);
    };
    double sum = 0;
    for (int j = -1; j <= 2; ++j) {
      for (int i = -1; i <= 2; ++i) {
        sum += weight(std::abs(across - i)) * weight(std::abs(down - j)) *
               extended(left, top, right - left, bottom - top, i, j, channel);
      }
    }
    return sum;
  }

  /// Cubic convolution (R. Keys 1981), a = -1/2.
  static double keys(double s) {
    if (s >= 2) return 0;
    return s < 1 ? (1.5 * s - 2.5) * s * s + 1 : ((-0.5 * s + 2.5) * s - 4) * s + 2;
  }

  /// The pixel of the grid; outside the picture on the line through the two inside it.
  double extended(int left, int top, int width, int height, int i, int j, std::size_t channel) const {
    const int x = left + i * width;
    const int y = top + j * height;
    if ((x < 0 || x >= whole_.width) && width > 0) {
      return 2 * extended(left, top, width, height, i < 0 ? 0 : 1, j, channel) -
             extended(left, top, width, height, i < 0 ? 1 : 0, j, channel);
    }
    if ((y < 0 || y >= whole_.height) && height > 0) {
      return 2 * extended(left, top, width, height, i, j < 0 ? 0 : 1, channel) -
             extended(left, top, width, height, i, j < 0 ? 1 : 0, channel);
    }
    return static_cast<double>(whole_.pixel(x, y)[channel]);
  }
};

void compare_blocks(const picture& whole, const segments& asked) {
  const auto& [image, times_traced, counts] = fill_from(whole, asked);
  const blocks_by_definition expected(whole, asked);
  CAPTURE(whole.width, whole.height, asked.length, asked.limit, static_cast<int>(asked.inner));
  REQUIRE(times_traced == expected.times_traced);
  require_rounded(image, expected.exact);
  const auto traced = static_cast<std::uint64_t>(std::ranges::count(times_traced, 1));
  REQUIRE(counts.traced == traced);
  REQUIRE(counts.interpolated == times_traced.size() - traced);
  const auto ends = [&](int side) {
    return static_cast<std::uint64_t>(std::ceil(static_cast<double>(side) / asked.length)) + 1;
  };
  REQUIRE(counts.elements_2_29 == ends(whole.width) * ends(whole.height));
  if (asked.length == 1) REQUIRE(image.rgb == whole.rgb);
  if (asked.inner == inner_colours::bicubic) return;
  if (asked.limit > 500) REQUIRE(traced <= counts.elements_2_29);
  // Ties up; sums of sixteenths and the like hit the half, or miss it by more than this.
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    if (image.rgb[i] != std::floor(expected.exact[i] + 0.5 + 1e-9))
      FAIL("channel " << i << " is " << int{image.rgb[i]} << ", expected " << expected.exact[i]);
  }
}

TEST_CASE("blocks are interpolated from four corners that are alike", "[render][segments]") {
  for (const int width : {1, 2, 9, 40, 65}) {
    for (const int height : {1, 2, 17, 30}) {
      for (const int length : {1, 3, 8, 64}) {
        for (const double limit : {0.0, 2.3, 5.0, 1000.0}) {
          for (const inner_colours inner : {inner_colours::bilinear, inner_colours::bicubic}) {
            compare_blocks(noise(width, height, 3), {.length = length, .limit = limit, .inner = inner});
          }
        }
      }
    }
  }
  // Far from grey, so that cubics leave 0..255.
  compare_blocks(noise(50, 40, 127), {.length = 9, .limit = 1000, .inner = inner_colours::bicubic});
}

TEST_CASE("bicubic blocks follow surfaces of second degree", "[render][segments]") {
  constexpr int kWidth = 49, kHeight = 33, kLength = 8;
  picture curved(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const int u = x - 24;
      const int v = y - 16;
      // All values at the corners of blocks are integers, so that nothing is rounded there.
      curved.pixel(x, y)[0] = static_cast<std::uint8_t>(std::lround(40 + (u * u + u * v + v * v) / 16.0));
    }
  }
  const auto error_of = [&](inner_colours inner, int margin) {
    const filled made = fill_from(curved, {.length = kLength, .limit = 1000, .inner = inner});
    int worst = 0;
    for (int y = margin; y < kHeight - margin; ++y) {
      for (int x = margin; x < kWidth - margin; ++x)
        worst = std::max(worst, std::abs(curved.pixel(x, y)[0] - made.image.pixel(x, y)[0]));
    }
    return worst;
  };
  // A block at the picture's edge has the slope of the chord there.
  CHECK(error_of(inner_colours::bicubic, kLength) == 0);
  CHECK(error_of(inner_colours::bicubic, 0) > 0);
  // A plane through the corners misses the second derivatives, 1/8 in x and in y, by 8^2 / 8 of each in the middle.
  CHECK(error_of(inner_colours::bilinear, kLength) == Approx(2 * (1.0 / 8) * 64 / 8).margin(1));
  // Corners, and nothing besides: the grid of blocks of one size is their corners.
  const filled made = fill_from(curved, {.length = kLength, .limit = 1000, .inner = inner_colours::bicubic});
  CHECK(made.counts.traced == 7 * 5);
}

TEST_CASE("bilinear blocks follow planes with fewer pixels than rows take", "[render][segments]") {
  picture plane(65, 49);
  for (int y = 0; y < 49; ++y) {
    for (int x = 0; x < 65; ++x) plane.pixel(x, y)[1] = static_cast<std::uint8_t>(5 + 2 * x + 2 * y);
  }
  const auto filled_by = [&](auto fill, inner_colours inner) {
    filled made{picture(65, 49), {}, {}};
    const segments asked{.length = 16, .limit = 1000, .inner = inner};
    made.counts = fill(made.image, asked, [&](std::span<const std::uint32_t> pixels) {
      for (const std::uint32_t each : pixels)
        std::copy_n(plane.rgb.begin() + 3 * each, 3, made.image.rgb.begin() + 3 * each);
    });
    return made;
  };
  const filled blocks = filled_by(fill_by_blocks, inner_colours::bilinear);
  const filled rows = filled_by(fill_by_segments, inner_colours::linear);
  CHECK(blocks.image.rgb == plane.rgb);
  CHECK(rows.image.rgb == plane.rgb);
  // 5 by 4 corners; 5 ends in each of 49 rows.
  CHECK(blocks.counts.traced == 20);
  CHECK(rows.counts.traced == 5 * 49);
  // (2.31): ceil(65 / (60 + 1)) + 1 in each of the four rows with traced pixels.
  CHECK(blocks.counts.elements_2_31 == 4 * 3);
}

}  // namespace
