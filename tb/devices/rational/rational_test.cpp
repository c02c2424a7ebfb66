// SPDX-License-Identifier: Apache-2.0
// The words of the memories against 50 digits, the distance of both fits from cos^n, the ends of the lobe, and what the
// device says of itself.
#include <boost/multiprecision/cpp_dec_float.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "rtl_sysc/devices/rational/formats.h"
#include "tb/catch.h"
#include "tb/device.h"
#include "tb/specular/specular.h"
#include "tb/specular/test/lobe_ends.h"
#include "tb/visit_format.h"

namespace {

using namespace blysk;
using real50 = boost::multiprecision::cpp_dec_float_50;

const specular::device_of_points& points_of(const selection& asked) {
  return dynamic_cast<const specular::device_of_points&>(asked.of());
}

/// x * 2^bits rounded to nearest, ties up.
std::int64_t rounded(const real50& x, int bits) {
  return static_cast<std::int64_t>(floor(ldexp(x, bits) + real50(1) / 2));
}

/// r and d by two linear equations: at u = 1 - v^(1/n) the lobe is v, so that r u (1 - v) + s u v = 1 - v with s = r + d.
std::array<real50, 2> solved(int n) {
  const real50 levels[] = {real50(425856) / 1000000, real50(50698) / 1000000};
  real50 of_r[2];
  real50 of_s[2];
  real50 right[2];
  for (int i = 0; i < 2; ++i) {
    const real50 u = 1 - pow(levels[i], real50(1) / n);
    of_r[i] = u * (1 - levels[i]);
    of_s[i] = u * levels[i];
    right[i] = 1 - levels[i];
  }
  const real50 determinant = of_r[0] * of_s[1] - of_r[1] * of_s[0];
  const real50 r = (right[0] * of_s[1] - right[1] * of_s[0]) / determinant;
  const real50 s = (of_r[0] * right[1] - of_r[1] * right[0]) / determinant;
  return {r, s - r};
}

using formula = std::function<double(double n, double c)>;

formula formula_of(const std::string& fit) {
  const selection asked = choose("rational", "q8", {{"fit", fit}});
  return points_of(asked).formula(asked);
}

/// (c - k m)/(1 + b m), m = (n - 1)(1 - c), 0 beyond its root: c itself at n = 1.
formula through_one(double k, double b) {
  return [k, b](double n, double c) {
    const double m = (n - 1) * (1 - c);
    return std::max(0.0, c - k * m) / (1 + b * m);
  };
}

/// How far a lobe is from c^n at most where c^n is `level` or more, at 2001 cosines down to where c^n is 1e-6 and at the kink
/// where the lobe ends.
double distance(const formula& lobe, double n, double level = 0) {
  const double lowest = n < 8 ? 0 : std::pow(1e-6, 1 / n);
  double largest = 0;
  double above = 1;  // the last cosine within the lobe
  for (int i = 0; i <= 2000; ++i) {
    const double c = 1 - (1 - lowest) * i / 2000;
    const double power = std::pow(c, n);
    if (power < level) break;
    const double value = lobe(n, c);
    largest = std::max(largest, std::fabs(value - power));
    if (value > 0) {
      above = c;
      continue;
    }
    double outside = c;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (outside + above) / 2;
      (lobe(n, middle) > 0 ? above : outside) = middle;
    }
    return std::max(largest, std::pow(outside, n));  // c^n falls from there on
  }
  return largest;
}

double distance_for_all(const formula& lobe, double level = 0) {
  double largest = 0;
  for (int n = 1; n <= 1000; ++n) largest = std::max(largest, distance(lobe, n, level));
  return largest;
}

}  // namespace

TEST_CASE("the words are r and d, rounded, for every width", "[contents]") {
  for (int n = 1; n <= 1000; ++n) {
    const auto exact = solved(n);
    for (const auto name : format_names) {
      visit_format(std::string(name), [&]<class Q>() {
        using formats = rational_formats<Q, rational_fit::best>;
        const auto& words = formats::contents::words;
        const auto at = static_cast<std::size_t>(n);
        CAPTURE(n, formats::fall_bits);
        REQUIRE(words[0][at] == rounded(exact[0], formats::fall_bits));
        REQUIRE(words[1][at] == rounded(exact[1], formats::rise_bits));
        return 0;
      });
    }
  }
}

TEST_CASE("the words before 1 and at the ends", "[contents]") {
  const auto& words = fit_words<9>::words;
  CHECK(words[0][0] == 0);  // not legal
  CHECK(words[1][0] == 0);
  CHECK(words[0][1] == 512);  // the lobe of n = 1 is c itself: r = 1, d = 0
  CHECK(words[1][1] == 0);
  // 512 (0.270491 n + 1/2) and 512 (0.944172 n - 1/2), which docs/devices/rational.md gives for large n.
  CHECK(std::fabs(static_cast<double>(words[0][1000]) - 512 * 270.991) < 1);
  CHECK(std::fabs(static_cast<double>(words[1][1000]) - 512 * 943.672) < 1);
}

TEST_CASE("the formulas at points where hand arithmetic gives them", "[formula]") {
  const selection line = choose("rational", "q8", {{"fit", "line"}});
  const auto on_line = points_of(line).formula(line);
  // (4 - (n + 3) u)/(4 + 4 (n - 1) u)
  CHECK(on_line(1, 0.3) == Approx(0.3).epsilon(1e-15));
  CHECK(on_line(2, 0.75) == Approx(11.0 / 20).epsilon(1e-15));          // u = 1/4: (4 - 5/4)/(4 + 1)
  CHECK(on_line(7, 0.875) == Approx(11.0 / 28).epsilon(1e-15));         // u = 1/8: (4 - 10/8)/(4 + 24/8)
  CHECK(on_line(100, 0.984375) == Approx(153.0 / 652).epsilon(1e-14));  // u = 1/64: (256 - 103)/(256 + 396)
  CHECK(on_line(1000, 0.9990234375) == Approx(3093.0 / 8092).epsilon(1e-14));  // u = 1/1024
  CHECK(on_line(7, 0.5) == 0);                                                 // beyond the root u = 4/10
  const selection best = choose("rational", "q8");
  const auto by_levels = points_of(best).formula(best);
  for (const double n : {2.0, 7.0, 100.0, 1000.0}) {  // it meets c^n at the levels
    for (const double level : {0.425856, 0.050698}) {
      CAPTURE(n, level);
      CHECK(by_levels(n, std::pow(level, 1 / n)) == Approx(level).epsilon(1e-12));
    }
  }
}

TEST_CASE("the distances from cos^n that docs/devices/rational.md tells", "[distance]") {
  struct row {
    formula lobe;
    double n1, n2, n10, n100, n1000, all;
  };
  const double k = 0.270491;
  const double b = 0.944172;
  const formula asymptote = [=](double n, double c) {
    const double u = 1 - c;
    return std::max(0.0, 1 - (k * n + 0.5) * u) / (1 + (b * n - 0.5) * u);
  };
  const row rows[] = {
      {formula_of("best"), 0, 0.0206, 0.0246, 0.0248, 0.0248, 0.0248},
      {asymptote, 0.1589, 0.0479, 0.0256, 0.0248, 0.0248, 0.1589},
      {through_one(k, b), 0, 0.0453, 0.0320, 0.0256, 0.0249, 0.0453},
      {through_one(0.5, 0.5), 0, 0.1111, 0.1344, 0.1353, 0.1353, 0.1353},
      {through_one(0, 1), 0, 0.0902, 0.1787, 0.2011, 0.2034, 0.2034},
      {formula_of("line"), 0, 0.0400, 0.0268, 0.0304, 0.0314, 0.0400},
  };
  const auto near = [](double value) { return Approx(value).margin(5.01e-5).epsilon(0); };
  for (const row& each : rows) {
    CHECK(distance(each.lobe, 1) == near(each.n1));
    CHECK(distance(each.lobe, 2) == near(each.n2));
    CHECK(distance(each.lobe, 10) == near(each.n10));
    CHECK(distance(each.lobe, 100) == near(each.n100));
    CHECK(distance(each.lobe, 1000) == near(each.n1000));
    CHECK(distance_for_all(each.lobe) == near(each.all));
  }
  CHECK(distance_for_all(formula_of("best"), 0.56) == near(0.0248));
  CHECK(distance_for_all(formula_of("line"), 0.56) == near(0.0293));
}

TEST_CASE("among powers of two k = 1/4 and b = 1 are the best", "[distance]") {
  for (const double k : {1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2}) {
    for (const double b : {1.0 / 4, 1.0 / 2, 1.0, 2.0}) {
      if (k == 0.25 && b == 1) continue;
      CAPTURE(k, b);
      CHECK(distance(through_one(k, b), 1000) > 2 * 0.0400);
    }
  }
}

TEST_CASE("the peak is 1 for every n, and beyond the root the lobe is 0", "[ends]") {
  for (const char* fit : {"best", "line"}) {
    for (const auto name : format_names) {
      const selection asked = choose("rational", std::string(name), {{"fit", fit}});
      const std::int64_t one = std::int64_t{1} << asked.fraction();
      for (const specular::lobe_ends& each : specular::lobe_ends_of(asked)) {
        CAPTURE(fit, name, each.n);
        REQUIRE(each.at_peak == one);
        if (!each.has_root) continue;
        REQUIRE(each.at_root == 0);
        REQUIRE(each.at_zero == 0);
      }
    }
  }
}

TEST_CASE("rational says what it is", "[words]") {
  const selection small = choose("rational", "q8");
  CHECK(small.text() == "device rational, format q8, coefficients from two memories of 1000 words");
  CHECK(small.of().rom_bits(small) == 1000 * (18 + 19));
  const selection line = choose("rational", "q24", {{"fit", "line"}});
  CHECK(line.text() == "device rational, format q24, coefficients (n + 3)/4 and n - 1");
  CHECK(line.of().rom_bits(line) == 0);
  CHECK_THROWS_WITH(choose("rational", "q8", {{"fit", "worst"}}), "--fit is worst, expected best, line");
}
