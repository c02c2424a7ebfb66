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

struct filled {
  picture image;
  std::vector<int> times_traced;
  segment_counts counts;
};

filled fill_from(const picture& whole, const segments& asked) {
  filled made{picture(whole.width, whole.height), std::vector<int>(whole.rgb.size() / 3, 0), {}};
  made.counts = fill_by_segments(made.image, asked, [&](std::span<const std::uint32_t> pixels) {
    for (const std::uint32_t each : pixels) {
      ++made.times_traced[each];
      std::copy_n(whole.rgb.begin() + 3 * each, 3, made.image.rgb.begin() + 3 * each);
    }
  });
  return made;
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
    asked.by_segments = segments{};
    asked.threads = 3;
    const outcome some = render::render(asked);
    asked.threads = 1;
    asked.asked = effects::all;
    REQUIRE(render::render(asked).image.rgb == some.image.rgb);
    REQUIRE(some.by_segments->traced == some.points);
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

}  // namespace
