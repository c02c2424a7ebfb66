// SPDX-License-Identifier: Apache-2.0
// UA 71489 against the function of [A] and against cos^n.
#include <algorithm>
#include <array>
#include <cmath>

#include "rtl_sysc/devices/angle/formats.h"
#include "tb/catch.h"
#include "tb/device.h"
#include "tb/golden/angle.h"
#include "tb/golden/pi.h"
#include "tb/golden/reflectance.h"
#include "tb/harness/systemc_engine.h"

namespace {

using namespace blysk;

enum result : std::size_t { kAngle, kBrdf, kOut };

struct line {
  int n;
  int intensity;
  double start, step;  // rad
  int count;
};

int angle_bits(const selection& asked) {
  return asked.fraction() + 10;
}

std::int64_t code_of(const selection& asked, double angle) {
  return static_cast<std::int64_t>(std::floor(std::ldexp(angle, angle_bits(asked)) + 0.5));
}

columns rows_of(const selection& asked, const std::vector<line>& lines) {
  columns in(asked.of().ports(asked), port::role::data);
  in.resize(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    in[0].set(i, lines[i].n);
    in[1].set(i, lines[i].intensity);
    in[2].set(i, code_of(asked, lines[i].start));
    in[3].set(i, code_of(asked, lines[i].step));
    in[4].set(i, lines[i].count);
  }
  return in;
}

columns drawn(const selection& asked, const line& wanted) {
  columns out;
  asked.of().make_bit(asked)->run(rows_of(asked, {wanted}), out);
  REQUIRE(out.size() == static_cast<std::size_t>(wanted.count));
  return out;
}

/// Largest |d/dy cos^k y|.
double steepest(double k) {
  return k == 1 ? 1 : std::sqrt(k) * std::pow((k - 1) / k, (k - 1) / 2);
}

/// How far the BRDF may be from [A]'s: rounding the product to an address of ROM 1, the two operands of multiplier 2, and
/// the word.
template <class Q>
double bound(int n, int powers, double level) {
  using formats = angle_formats<Q>;
  const double k = std::min(powers, n);
  const double factor = golden::angle_scale<double>(n, k, level) * 2 / golden::pi<double>();
  const double turned = std::ldexp(1, -formats::address_bits - 1) +
                        std::ldexp(factor, -formats::limited_bits - 1) +
                        std::ldexp(1 / factor, -formats::factor_bits - 1);
  return steepest(k) * golden::pi<double>() / 2 * turned + std::ldexp(1, -Q::frac - 1);
}

/// Largest error / bound of a line over the whole lobe.
template <class Q>
double share_of_bound(const std::string& format, int n, const std::string& level, int powers) {
  const selection asked = choose("angle", format, {{"q", level}, {"k", std::to_string(powers)}});
  const double q = std::stod(level);
  const double k = std::min(powers, n);
  const double end = golden::angle_limit<double>(n, k, q);
  const columns out = drawn(asked, {n, 255, 0, end * 1.02 / 1023, 1023});
  double share = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double angle = std::ldexp(out[kAngle].real(i), -angle_bits(asked));
    const double brdf = std::ldexp(out[kBrdf].real(i), -Q::frac);
    share =
        std::max(share, std::abs(brdf - golden::angle_lobe<double>(n, k, q, angle)) / bound<Q>(n, powers, q));
    REQUIRE(out[kOut].get(i) == 255 * out[kBrdf].get(i));
  }
  return share;
}

template <class Q>
double largest_share(const std::string& format) {
  double share = 0;
  for (const auto& [level, powers] :
       {std::pair{"0.5", 5}, {"0.1", 1}, {"0.9", 1}, {"0.6", 3}, {"0.999", 15}}) {
    for (const int n : {1, 2, 3, 4, 5, 6, 15, 16, 50, 200, 1000}) {
      const double each = share_of_bound<Q>(format, n, level, powers);
      CAPTURE(format, level, powers, n);
      CHECK(each <= 1);
      share = std::max(share, each);
    }
  }
  return share;
}

/// The factor of the lobe, by [A]'s formulas.
double factor_of(const std::string& energy, double n, double k, double level) {
  if (energy == "safe") return golden::angle_coefficient_safe(n, k, level);
  if (energy == "published" && n > k) return golden::angle_coefficient_fitted(n, k, level);
  return golden::angle_coefficient_exact(n, k, level);
}

std::string refusal(const std::map<std::string, std::string>& options) {
  try {
    choose("angle", "q8", options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the lobe is within its bound of [A]'s function, and the bound is tight", "[angle]") {
  for (const double share : {largest_share<q8>("q8"), largest_share<q12>("q12"), largest_share<q16>("q16"),
                             largest_share<q24>("q24")}) {
    CHECK(share > 0.8);
  }
}

TEST_CASE("no word is lost on the way from the axis to the lobe's end", "[angle]") {
  // Each word of a part is met, in order: the lobe falls from 1 to 0.
  const selection asked = choose("angle", "q8");
  for (const int n : {1, 2, 5, 6, 1000}) {
    const double k = std::min(5, n);
    const double end = golden::angle_limit<double>(n, k, 0.5);
    const columns out = drawn(asked, {n, 1, 0, end * 1.01 / 1023, 1023});
    CAPTURE(n);
    CHECK(out[kBrdf].get(0) == 256);
    CHECK(out[kBrdf].get(1022) == 0);
    bool falls = true;
    for (std::size_t i = 1; i < out.size(); ++i) falls = falls && out[kBrdf].get(i) <= out[kBrdf].get(i - 1);
    CHECK(falls);
  }
}

TEST_CASE("the reflectance never rises with the angle: every exponent, every code at multiplier 2",
          "[angle]") {
  for (const char* format : {"q8", "q12", "q24"}) {
    const selection asked = choose("angle", format);
    const std::int64_t pitch = std::int64_t{1}
                               << (angle_bits(asked) - asked.of().widths(asked).at("limited"));
    const auto model = asked.of().make_bit(asked);
    columns out;
    int exceptions = 0;
    for (int n = 1; n <= 1000; ++n) {
      // Lines one after the other, from the axis to where the lobe has ended.
      const double end = golden::angle_limit<double>(n, std::min(5, n), 0.5);
      const std::int64_t codes = std::min(code_of(asked, 1.001 * end), code_of(asked, 1.5707)) / pitch;
      const std::int64_t lines = codes / 1023 + 1;
      columns in(asked.of().ports(asked), port::role::data);
      in.resize(static_cast<std::size_t>(lines));
      for (std::int64_t i = 0; i < lines; ++i) {
        const auto row = static_cast<std::size_t>(i);
        in[0].set(row, n);
        in[1].set(row, 255);
        in[2].set(row, i * 1023 * pitch);
        in[3].set(row, pitch);
        in[4].set(row, 1023);
      }
      model->run(in, out);
      REQUIRE(out.size() == static_cast<std::size_t>(lines) * 1023);
      REQUIRE(out[kBrdf].get(0) == std::int64_t{1} << asked.fraction());
      REQUIRE(out[kBrdf].get(out.size() - 1) == 0);
      for (std::size_t i = 1; i < out.size(); ++i)
        exceptions += out[kBrdf].get(i) > out[kBrdf].get(i - 1) || out[kOut].get(i) > out[kOut].get(i - 1);
    }
    CAPTURE(format);
    CHECK(exceptions == 0);
  }
}

TEST_CASE("an exponent up to k is cos^n itself", "[angle]") {
  const selection asked = choose("angle", "q16", {{"q", "0.3"}, {"k", "5"}});
  for (int n = 1; n <= 5; ++n) {
    const columns out = drawn(asked, {n, 255, 0, 0.00153, 1023});
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double angle = std::ldexp(out[kAngle].real(i), -angle_bits(asked));
      const double exact = std::pow(std::cos(angle), n);
      CAPTURE(n, angle);
      CHECK(std::abs(std::ldexp(out[kBrdf].real(i), -16) - exact) <= bound<q16>(n, 5, 0.3));
    }
  }
}

TEST_CASE("the reflectance is 0 beyond the end of the lobe, at any distance", "[angle]") {
  for (const char* format : {"q8", "q16", "q24"}) {
    const selection asked = choose("angle", format);
    const double address = std::ldexp(1, -angle_formats<q8>::address_bits);
    for (const int n : {1, 2, 4, 5, 6, 7, 1000}) {
      const double end = golden::angle_limit<double>(n, std::min(5, n), 0.5);
      CAPTURE(format, n);
      const columns near = drawn(asked, {n, 255, std::min(1.57, end * (1 + address)), 0.001, 2});
      CHECK(near[kBrdf].get(1) == 0);
      const columns far = drawn(asked, {n, 255, 1.57, 0.1249, 1023});
      CHECK(far[kAngle].real(1022) > std::ldexp(129.0, angle_bits(asked)));
      for (std::size_t i = 1; i < far.size(); ++i) REQUIRE(far[kOut].get(i) == 0);
    }
  }
}

TEST_CASE("the axis reflects all, whatever the exponent", "[angle]") {
  const selection asked = choose("angle", "q12");
  for (int n = 1; n <= 1000; ++n) {
    const columns out = drawn(asked, {n, 255, 0, 0, 1});
    REQUIRE(out[kBrdf].get(0) == 1 << 12);
    REQUIRE(out[kOut].get(0) == 255 << 12);
  }
}

TEST_CASE("a line through the axis is the same on both sides", "[angle]") {
  const selection asked = choose("angle", "q12");
  for (const int n : {1, 10, 1000}) {
    const columns out = drawn(asked, {n, 200, 0.25, -0.0078125, 65});  // 32 steps down to the axis, 32 beyond
    CHECK(out[kAngle].get(32) == 0);
    CHECK(out[kOut].get(32) == 200 << 12);
    for (std::size_t i = 0; i < 32; ++i) {
      CAPTURE(n, i);
      CHECK(out[kAngle].get(64 - i) == -out[kAngle].get(i));
      CHECK(out[kBrdf].get(64 - i) == out[kBrdf].get(i));
    }
  }
}

TEST_CASE("a line takes its pixels and two cycles, a count of 0 one pixel", "[angle]") {
  const selection asked = choose("angle", "q8", {{"k", "15"}});  // all four outputs of the decoder
  const auto device = harness::make_systemc(asked);
  columns out;
  std::vector<line> lines;
  for (int n = 1; n <= 20; ++n) lines.push_back({n, 255, 1.5, -0.03, 100});
  device->run(rows_of(asked, lines), out);
  columns expected;
  asked.of().make_bit(asked)->run(rows_of(asked, lines), expected);
  CHECK(out == expected);
  const line wanted{20, 255, 0.3, -0.01, 100};
  device->run(rows_of(asked, {wanted}), out);
  REQUIRE(out.size() == 100);
  std::uint64_t before = device->cycles();
  device->run(rows_of(asked, std::vector<line>(50, wanted)), out);
  REQUIRE(out.size() == 50 * 100);
  // One cycle until the first row is offered.
  CHECK(device->cycles() - before == 50 * (100 + 2) + 1);
  before = device->cycles();
  device->run(rows_of(asked, {{1, 255, 0, 0, 0}}), out);  // not legal
  CHECK(out.size() == 1);
  CHECK(device->cycles() - before == 1 + 2 + 1);
  CHECK(out[kOut].get(0) == 255 << 8);
}

TEST_CASE("the words of ROM 2 are as survivors.txt and uncovered.txt say", "[angle]") {
  using formats = angle_formats<q8>;
  std::array<std::int64_t, 1001> words{};
  fill_factors(words, 500000, 5, formats::factor_bits);
  CHECK(words[0] == 0);
  bool reaches_end = true;
  for (std::size_t n = 1; n < words.size(); ++n) {
    REQUIRE(words[n] < std::int64_t{16} << formats::factor_bits);
    // From which limited angle on it does not matter where limit4 cuts.
    for (const std::int64_t limited : {65527, 65531, 65535}) {
      reaches_end =
          reaches_end && formats::quant2::law(formats::mul2::law(limited, words[n])) == formats::place::max;
    }
  }
  CHECK(reaches_end);
}

TEST_CASE("a number is one however it is written", "[angle]") {
  for (const char* level : {"0.5", ".5", "0.50", "0.500000"}) {
    for (const char* powers : {"5", "05"}) {
      CAPTURE(level, powers);
      const selection asked = choose("angle", "q8", {{"q", level}, {"k", powers}});
      CHECK(asked.is_preset());
      CHECK(asked.text() == choose("angle", "q8").text());
    }
  }
  CHECK(choose("angle", "q8", {{"q", "0.000001"}}).value("q") == "0.000001");
  CHECK(choose("angle", "q8", {{"q", "0.123450"}}).value("q") == "0.12345");
}

TEST_CASE("options that are no Q or k are refused in one line", "[angle]") {
  for (const char* q :
       {"0", "1", "0.0", "1.0", "1.5", "-0.5", "0.", "", "0.1234567", "0.5x", "5e-1", "nan"}) {
    CHECK(refusal({{"q", q}}) ==
          std::string("--q is ") + q +
              ", expected a decimal number above 0 and below 1 with at most six decimals");
  }
  for (const char* k : {"0", "16", "-1", "2.5", "", "5x"})
    CHECK(refusal({{"k", k}}) == std::string("--k is ") + k + ", expected an integer 1..15");
  CHECK(refusal({{"coefficient", "derived"}}) ==
        "device angle has no option --coefficient, expected --q, --k, --energy");
  CHECK(refusal({{"q", "0.999999"}, {"k", "15"}}).empty());
  CHECK(refusal({{"q", ".000001"}}).empty());
}

TEST_CASE("a factor of the lobe that does not exist, or does not hold, is refused in one line", "[angle]") {
  CHECK(refusal({{"energy", "fitted"}}) == "--energy is fitted, expected none, published, exact, safe");
  const std::string holds =
      "--energy published holds for --q in [0.1, 0.4] or [0.5, 0.9] and --k in 1..5, expected these, not ";
  for (const char* q : {"0.09", "0.45", "0.400001", "0.95"})
    CHECK(refusal({{"energy", "published"}, {"q", q}}) == holds + "--q " + q + " --k 5, or --energy exact");
  CHECK(refusal({{"energy", "published"}, {"k", "6"}}) == holds + "--q 0.5 --k 6, or --energy exact");
  for (const char* energy : {"exact", "safe"})
    CHECK(refusal({{"energy", energy}, {"q", "0.45"}, {"k", "15"}}).empty());
  CHECK(choose("angle", "q8", {{"energy", "safe"}}).text() ==
        "device angle, format q8, Q 0.5, k 5, energy factor safe");
  CHECK(choose("angle", "q8").text() == "device angle, format q8, Q 0.5, k 5");
}

TEST_CASE("with a factor the reflectance is within its bound of the factor times [A]'s function", "[angle]") {
  double share = 0;
  for (const char* energy : {"published", "exact", "safe"}) {
    for (const int n : {1, 2, 5, 6, 16, 50, 200, 1000}) {
      for (const int powers : {1, 5}) {
        const double k = std::min(powers, n);
        const std::string text = std::to_string(powers);
        const double factor = factor_of(energy, n, k, 0.6);
        const double end = golden::angle_limit<double>(n, k, 0.6);
        const selection asked = choose("angle", "q12", {{"energy", energy}, {"q", "0.6"}, {"k", text}});
        const columns out = drawn(asked, {n, 255, 0, end * 1.02 / 1023, 1023});
        // Words of the memory are rounded to nearest, safe ones down.
        const double word =
            std::ldexp(energy == std::string("safe") ? 1 : 0.5, -angle_formats<q12>::energy_bits);
        const double lobe = bound<q12>(n, powers, 0.6);
        for (std::size_t i = 0; i < out.size(); ++i) {
          const double angle = std::ldexp(out[kAngle].real(i), -angle_bits(asked));
          const double exact = golden::angle_lobe<double>(n, k, 0.6, angle);
          const double allowed = factor * lobe + word * (exact + lobe) + std::ldexp(1, -13);
          const double error = std::abs(std::ldexp(out[kBrdf].real(i), -12) - factor * exact);
          CAPTURE(energy, n, powers, i);
          REQUIRE(error <= allowed);
          REQUIRE(out[kOut].get(i) == 255 * out[kBrdf].get(i));
          share = std::max(share, error / allowed);
        }
      }
    }
  }
  CHECK(share > 0.8);
}

TEST_CASE("the exact factor makes the reflectance of the pixels 1, with the angle from the mirror direction",
          "[angle]") {
  for (const int n : {1, 3, 6, 20, 200, 1000}) {
    const selection asked = choose("angle", "q16", {{"energy", "exact"}});
    const double end = golden::angle_limit<double>(n, std::min(n, 5), 0.5);
    const columns out = drawn(asked, {n, 255, 0, std::min(end, 1.57) / 1000, 1001});
    // Riemann's sum of 2 pi brdf cos x sin x.
    double sum = 0;
    const double step = std::ldexp(out[kAngle].real(1), -angle_bits(asked));
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double x = static_cast<double>(i) * step;
      sum +=
          2 * golden::pi<double>() * std::ldexp(out[kBrdf].real(i), -16) * std::cos(x) * std::sin(x) * step;
    }
    // The bound of each pixel, and 1/500 for the sum and its end.
    const double factor = factor_of("exact", n, std::min(n, 5), 0.5);
    const double off =
        factor * bound<q16>(n, 5, 0.5) * golden::pi<double>() * std::pow(std::sin(std::min(end, 1.57)), 2);
    CAPTURE(n, sum, off);
    CHECK(std::abs(sum - 1) <= off + 0.002);
  }
}

TEST_CASE("the safe factor keeps the reflectance at or below 1 in both readings of the angle", "[angle]") {
  using golden::lobe_axis;
  double largest = 0;
  for (const double q : {0.1, 0.5, 0.9}) {
    for (const int powers : {1, 2, 5, 15}) {
      const angle_factor words(static_cast<std::uint64_t>(std::lround(q * 1e6)),
                               static_cast<std::uint64_t>(powers));
      for (const int n : {1, 2, 3, 5, 8, 16, 40, 200, 1000}) {
        const double factor = std::ldexp(
            static_cast<double>(words.energy_word(angle_energy::safe, static_cast<std::uint64_t>(n), 19)),
            -19);
        for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
          for (const lobe_axis axis : {lobe_axis::half_vector, lobe_axis::mirror}) {
            const double r = golden::angle_reflectance(n, std::min(powers, n), q, factor, axis, degrees);
            CAPTURE(q, powers, n, degrees);
            CHECK(r <= 1);
            largest = std::max(largest, r);
          }
        }
      }
    }
  }
  CHECK(largest > 0.98);  // close for narrow lobes
}

TEST_CASE("the device says how large its memories are", "[angle]") {
  const selection small = choose("angle", "q8");
  CHECK(small.of().rom_bits(small) == 5 * 512 * 9 + 1000 * 18);
  const selection one = choose("angle", "q24", {{"k", "1"}});
  CHECK(one.of().rom_bits(one) == 1024 * 25 + 1000 * 19);
  const selection factor = choose("angle", "q8", {{"energy", "exact"}});
  CHECK(factor.of().rom_bits(factor) == 5 * 512 * 9 + 1000 * 18 + 1000 * 24);
}
