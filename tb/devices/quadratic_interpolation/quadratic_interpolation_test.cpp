// SPDX-License-Identifier: Apache-2.0
// Forward differences against the polynomial itself.
#include <algorithm>
#include <cmath>
#include <random>

#include "tb/catch.h"
#include "tb/device.h"
#include "tb/golden/interpolation/triangle.h"
#include "tb/harness/systemc_engine.h"

namespace {

using namespace blysk;

/// One line with the same coefficients in all channels, raw.
columns line_of(const selection& asked, std::int64_t length, std::int64_t value, std::int64_t first,
                std::int64_t second) {
  columns in(asked.of().ports(asked), port::role::data);
  in.resize(1);
  in[0].set(0, length);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    in[1 + 3 * channel].set(0, value);
    in[2 + 3 * channel].set(0, first);
    in[3 + 3 * channel].set(0, second);
  }
  return in;
}

}  // namespace

TEST_CASE("a parabola that the bits hold is drawn exactly", "[quadratic-interpolation]") {
  // 255 - (x - 8)^2 / 4: value 239, first difference 3.75, second difference -0.5.
  const selection asked = choose("quadratic-interpolation", "q8");
  columns out;
  asked.of().make_bit(asked)->run(line_of(asked, 16, 239 * 256, 960, -128), out);
  REQUIRE(out.size() == 17);
  for (int x = 0; x <= 16; ++x) {
    const double exact = 255 - (x - 8) * (x - 8) / 4.0;
    CAPTURE(x);
    CHECK(out[0].get(static_cast<std::size_t>(x)) == static_cast<std::int64_t>(std::floor(exact + 0.5)));
  }
  CHECK(out[0] == out[1]);
  CHECK(out[0] == out[2]);
}

TEST_CASE("pixels are the polynomial, rounded and limited", "[quadratic-interpolation]") {
  std::mt19937 random(11);
  for (const char* format : {"q8", "q16", "q24"}) {
    const selection asked = choose("quadratic-interpolation", format);
    const auto model = asked.of().make_bit(asked);
    const int frac = asked.fraction();
    columns out;
    for (int i = 0; i < 200; ++i) {
      const auto code = [&](double low, double high) {
        return static_cast<std::int64_t>(std::ldexp(std::uniform_real_distribution(low, high)(random), frac));
      };
      const std::int64_t length = static_cast<std::int64_t>(random() % 1024);
      const std::int64_t value = code(0, 255);
      const std::int64_t first = code(-4, 4);
      const std::int64_t second = code(-0.05, 0.05);
      model->run(line_of(asked, length, value, first, second), out);
      REQUIRE(out.size() == static_cast<std::size_t>(length) + 1);
      for (std::int64_t x = 0; x <= length; ++x) {
        // In integers, so exact: 2^frac times the polynomial, then floor(. + 1/2).
        const std::int64_t exact = value + x * first + x * (x - 1) / 2 * second;
        const std::int64_t rounded = (exact + (std::int64_t{1} << (frac - 1))) >> frac;
        const std::int64_t expected = rounded < 0 ? 0 : rounded > 255 ? 255 : rounded;
        if (out[1].get(static_cast<std::size_t>(x)) == expected) continue;
        CAPTURE(format, length, value, first, second, x);
        FAIL("a pixel is wrong");
      }
    }
  }
}

TEST_CASE("a scan line of a triangle is the polynomial through its six intensities",
          "[quadratic-interpolation]") {
  // Vertices (0, 0), (200, 60), (40, 180), a highlight near the middle of the first edge.
  const golden::triangle<double> of{200, 60, 40, 180};
  const golden::quadratic_surface<double> surface =
      golden::surface_through<double>(of, {40, 80, 60, 200, 120, 180});
  for (const char* format : {"q16", "q24"}) {
    const selection asked = choose("quadratic-interpolation", format);
    const int frac = asked.fraction();
    const auto code = [&](double x) {
      return static_cast<std::int64_t>(std::floor(std::ldexp(x, frac) + 0.5));
    };
    for (const int y : {1, 30, 60, 90, 179}) {
      const int left = static_cast<int>(std::ceil(y * 40 / 180.0));
      const int right = static_cast<int>(std::floor(y <= 60 ? y * 200 / 60.0 : 200 - (y - 60) * 160 / 120.0));
      REQUIRE(left < right);
      columns out;
      asked.of().make_bit(asked)->run(
          line_of(asked, right - left, code(surface.at(left, y)), code(surface.first_difference(left, y)),
                  code(surface.second_difference())),
          out);
      REQUIRE(out.size() == static_cast<std::size_t>(right - left) + 1);
      for (int x = left; x <= right; ++x) {
        const double steps = x - left;
        const double rounded = std::ldexp(1 + steps + steps * (steps - 1) / 2, -frac - 1);
        const double exact = std::min(255.0, std::max(0.0, surface.at(x, y)));
        CAPTURE(format, y, x);
        CHECK(std::abs(out[0].real(static_cast<std::size_t>(x - left)) - exact) <= 0.5 + rounded + 1e-9);
      }
    }
  }
}

TEST_CASE("a line takes its pixels and a cycle", "[quadratic-interpolation]") {
  const selection asked = choose("quadratic-interpolation", "q8");
  const auto device = harness::make_systemc(asked);
  columns out;
  const columns in = line_of(asked, 99, 0, 256, 0);
  device->run(in, out);
  const std::uint64_t before = device->cycles();
  device->run(in, out);
  REQUIRE(out.size() == 100);
  CHECK(device->cycles() - before == 100 + 1 + 1);  // one cycle until the row is offered, one to take it
}
