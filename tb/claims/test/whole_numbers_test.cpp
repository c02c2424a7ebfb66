// SPDX-License-Identifier: Apache-2.0
// What whole numbers and a pencil decide.
#include <fmt/format.h>

#include <numeric>

#include "tb/catch.h"
#include "tb/claims/test/literal.h"
#include "tb/claims/test/second.h"
#include "tb/golden/registry.h"
#include "tb/golden/scene.h"

namespace blysk::claims {
namespace {

struct shift_errors {
  double largest = 0;
  double largest_relative = 0;
  double mean = 0;
};

/// 1/k to the nearest 2^-places, first <= k <= 16; (255 - 0)/k against it.
shift_errors by_rounding(int first, int places) {
  shift_errors result;
  for (int k = first; k <= 16; ++k) {
    const double reciprocal = std::round(std::ldexp(1.0, places) / k) / std::ldexp(1.0, places);
    const double relative = std::abs(1 - k * reciprocal);
    result.largest = std::max(result.largest, 255 * relative / k);
    result.largest_relative = std::max(result.largest_relative, relative);
    result.mean += relative / (17 - first);
  }
  return result;
}

/// Pixels of a row of the triangle (0, 0), (7, 8), (-9, 12) at height y, between its left and its right edge.
int row_width(int y) {
  const double left = -0.75 * y;
  const double right = y <= 8 ? 7 * y / 8.0 : 7 - 4.0 * (y - 8);
  return static_cast<int>(std::floor(right) - std::ceil(left)) + 1;
}

/// ceil(a / b)
int ceiling(int a, int b) {
  return (a + b - 1) / b;
}

/// 2.6 in whole numbers: the ends of ceil((row - 1)/(inner + 1)) segments are traced.
figures processing_elements() {
  int rows = 0;
  int exact = 0;
  int one_more = 0;
  int off = 0;
  int most = 0;
  int off_231 = 0;
  for (int row = 2; row <= 2048; ++row) {
    for (int pitch = 2; pitch <= 65; ++pitch) {
      ++rows;
      const int traced = ceiling(row - 1, pitch) + 1;
      const int difference = ceiling(row, pitch) + 1 - traced;
      exact += difference == 0;
      one_more += difference == 1;
      off = std::max(off, std::abs(difference));
      if ((row - 1) % pitch != 0) continue;
      // The sum of (2.31) is row - 1 with the 1 inside of it, and with the 1 outside the inner pixels and 1.
      const int segments = (row - 1) / pitch;
      for (const int by_2_31 : {ceiling(row, row - 1) + 1, ceiling(row, row - segments) + 1}) {
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

}  // namespace

TEST_CASE("whole numbers by hand", "[claims]") {
  std::map<std::string, figures> rows;
  const double a = literal::exact_a(1000);
  rows["P6"] = {{"words", 1024.0}, {"width", 2.0 * 8}, {"a", a}, {"fraction", 16.0 - 10}};
  CHECK((512 < a && a < 1024));
  rows["T22"] = {{"exact", 36 + 3.0 / 7}, {"shifted", 255.0 / 8 + 255.0 / 64}, {"digits", 8.0 + 1}};
  // 255/7 less 255 * 9/64: 255 (64 - 63) / 448
  rows["T23"] = {{"error", 255.0 / 448}, {"relative", 100.0 / 64}};
  const auto eight = by_rounding(2, 8);
  rows["T24"] = {
      {"largest", eight.largest}, {"mean", 100 * eight.mean}, {"mean_from_3", 100 * by_rounding(3, 8).mean}};
  for (const int places : {6, 7, 8}) {
    const auto errors = by_rounding(2, places);
    rows["T46"][fmt::format("s{}", places)] = 100 * errors.largest_relative;
    rows["T46"][fmt::format("s{}_mean", places)] = 100 * errors.mean;
  }
  rows["T25"] = {{"sums", 408.0},
                 {"divisions", 42.0},
                 {"edges", 3.0 * (7 + 11 + 15)},
                 {"row_divisions", 33.0},
                 {"row_sums", 66.0}};
  CHECK(18 + 99 + 66 + 225 == 408);
  CHECK(9 + 33 == 42);
  // Pick: area = inside + edge / 2 - 1; edge points by greatest common divisors.
  const int twice_area = std::abs(7 * 12 - 8 * -9);
  const int on_edge = std::gcd(7, 8) + std::gcd(9, 12) + std::gcd(16, 4);
  const int inside = (twice_area - on_edge + 2) / 2;
  rows["T26"] = {{"inside", static_cast<double>(inside)},
                 {"sums", 3.0 * inside},
                 {"on_edge", static_cast<double>(on_edge)}};
  int widest = 0;
  for (int y = 0; y <= 12; ++y) widest = std::max(widest, row_width(y));
  rows["T41"]["widest"] = static_cast<double>(widest);
  // 408 s + 42 d = 2946 or 2064: division by 6 leaves 5 s = 1 modulo 7, so s = 3, and s = 10 is too much.
  rows["T27"] = {{"ratio", 1 + 882.0 / 2064},
                 {"first", fmt::format("3 and {}", (2946 - 3 * 408) / 42)},
                 {"second", fmt::format("3 and {}", (2064 - 3 * 408) / 42)},
                 {"clocks", 187.0 / 131}};  // 1122 and 786 by 6
  CHECK((491 - 68 * 3) % 7 == 0);
  CHECK((344 - 68 * 3) % 7 == 0);
  CHECK(68 * 10 > 491);
  rows["T39"] = processing_elements();

  rows["E2"] = {{"eight", 201 / 256.0}, {"eight_off", -0.00084375}, {"zero", 50 / 64.0},
                {"zero_off", -0.00475}, {"one", 51 / 64.0},         {"one_off", 0.010875}};
  rows["E3"] = {{"zero", 786.0 / 1000},
                {"half", 1286.0 / 1000},
                {"exact", 0.0},
                {"bit_zero", 0.0},
                {"bit_one", 1.0 / 2}};
  rows["E6"]["lsb"] = 1 / 32768.0;
  rows["E14"]["digits"] = 256.0;
  // The triangle (0, 0), (8, 4), (4, 8) has D = 48; C12 = -280, C13 = -140, C23 = -400. P3 = (2 C12 16 - C23 32 + 2 C13 64)
  // over D^2 = -14080/2304; / Y2 * Y2 takes it 16 times, so at y = 8 misses by 15 P3 64. Without Y3 P4 is off by
  // 4 C12 4 (8 - 1)/D^2 = -31360/2304, and P3, which is made of it, by -2 times that: at (4, 8) 8 (4 - 16) times it. With
  // - 4 I23 C23 is off by 8 I23, of which the middle of 2 and 3 sees a quarter.
  CHECK(40 + 80 - 2 * 200 == -280);
  CHECK(40 + 60 - 2 * 120 == -140);
  CHECK(4 * (40 - 200 - 120 + 180) == -400);
  CHECK(2 * -280 * 16 + 400 * 32 + 2 * -140 * 64 == -14080);
  rows["E19"] = {{"term", 31360.0 / 2304 * 96}, {"division", 14080.0 / 2304 * 15 * 64}, {"blue", 2 * 180.0}};
  rows["E20"]["second"] = 0.0;  // C12 = I1 + I2 - (I1 + I2), and so are the others
  check_rows("whole numbers by hand", rows);
}

TEST_CASE("what no model takes is refused", "[claims]") {
  using namespace golden;
  const std::array zero{0.0, 0.5};
  CHECK_THROWS_AS(find_model("quadratic-published")->value(zero), std::domain_error);
  const vec3<double> light{0, 0, 1};
  CHECK(dot(light, half_vector(light, vec3<double>{0, 0, -1})) == 0);
  // 0.5 (0.25 - 0.5) + 0.5; L + V has no direction, and no length to divide by.
  check_rows("what no model takes is refused", {{"E16", {{"zero", "refused"}, {"a", 0.5}, {"half", 3.0 / 8}}},
                                                {"E17", {{"length", 0.0}, {"cos", 0.0}}}});
}

}  // namespace blysk::claims
