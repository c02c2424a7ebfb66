// SPDX-License-Identifier: Apache-2.0
// The words of the memories against 50 digits, the bound against 1 ulp, and what the device says of itself.
#include <boost/multiprecision/cpp_dec_float.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

#include "rtl_sysc/devices/power/formats.h"
#include "tb/catch.h"
#include "tb/device.h"
#include "tb/specular/specular.h"
#include "tb/visit_format.h"

namespace {

using namespace blysk;
using real50 = boost::multiprecision::cpp_dec_float_50;

/// What the memories of a format hold.
template <class Of>
constexpr auto& ratio_words = log_ratio_words<Of::ratio_segments, Of::word_bits, Of::value_bits>::words;
template <class Of>
constexpr auto& exp_words =
    power_words<Of::power_segments, Of::word_bits, Of::value_bits, Of::place_bits>::words;

/// x * 2^bits rounded to nearest, ties up.
std::int64_t rounded(const real50& x, int bits) {
  return static_cast<std::int64_t>(floor(ldexp(x, bits) + real50(1) / 2));
}

/// (1 - log2(1 + f))/(1 - f), by logarithms: another way than the words'.
real50 ratio(const real50& f) {
  if (f == 1) return 1 / (2 * log(real50(2)));
  return (1 - log(1 + f) / log(real50(2))) / (1 - f);
}

/// The line of docs/devices/power.md for each of 2^bits segments, its begin raised by half a unit of the cut.
template <class Words>
void check_lines(const Words& words, int segment_bits, int word_bits, int cut_bits,
                 const std::function<real50(const real50&)>& curve) {
  const real50 width = ldexp(real50(1), -segment_bits);
  REQUIRE(words[0].size() == std::size_t{1} << segment_bits);
  for (std::size_t i = 0; i < words[0].size(); ++i) {
    const real50 first = curve(real50(i) * width);
    const real50 middle = curve((real50(i) + real50(1) / 2) * width);
    const real50 last = curve(real50(i + 1) * width);
    const real50 sag = (first + last) / 2 - middle;
    CAPTURE(segment_bits, i);
    REQUIRE(words[0][i] == rounded(first - sag / 2 + ldexp(real50(1), -cut_bits - 1), word_bits));
    REQUIRE(words[1][i] == -rounded(first - last, word_bits));
  }
}

}  // namespace

TEST_CASE("the words are the lines, rounded, in every format", "[contents]") {
  for (const auto name : format_names) {
    visit_format(std::string(name), []<class Q>() {
      using of = power_formats<Q>;
      check_lines(ratio_words<of>, of::ratio_segments, of::word_bits, of::value_bits, ratio);
      // A number cut to its place lies half a unit above it in the mean.
      const real50 half = ldexp(real50(1), -of::place_bits - 1);
      check_lines(exp_words<of>, of::power_segments, of::word_bits, of::value_bits,
                  [&](const real50& x) { return pow(real50(2), real50(-x - half)); });
      return 0;
    });
  }
}

TEST_CASE("the words that hand arithmetic gives", "[contents]") {
  using of = power_formats<q8>;
  // ratio: 1, (1 - log2 1.125)/0.875 = 0.948657, (1 - log2 1.25)/0.75 = 0.904096; sag 0.003391; with 12 bits and 2^-12
  // beside: 1 - 0.001696 + 0.000244 = 0.998549 is 4090.05.
  CHECK(ratio_words<of>[0][0] == 4090);
  CHECK(ratio_words<of>[1][0] == -393);  // 0.095904 is 392.82
}

TEST_CASE("the bound is at most one output step in every format", "[bound]") {
  for (const auto name : format_names) {
    const selection asked = choose("power", std::string(name));
    const auto bound = dynamic_cast<const specular::device_of_points&>(asked.of()).bound(asked);
    const std::int64_t one = std::int64_t{1} << asked.fraction();
    const double ulp = std::ldexp(1.0, -asked.fraction());
    // All codes, or 512 next to 1, where large exponents have their lobes, and 512 evenly spread.
    const auto for_codes = [&](const std::function<void(std::int64_t)>& use) {
      if (one <= 4096) {
        for (std::int64_t code = 0; code <= one; ++code) use(code);
      } else {
        for (std::int64_t i = 0; i <= 512; ++i) {
          use(one - i);
          use(one / 512 * i);
        }
      }
    };
    double largest = 0;
    for (int n = 1; n <= 1000; ++n)
      for_codes(
          [&](std::int64_t code) { largest = std::max(largest, bound(n, static_cast<double>(code) * ulp)); });
    WARN(name << ": bound " << largest / ulp << " ulp");
    CHECK(largest <= ulp);
    CHECK(largest > 0.7 * ulp);
  }
}

TEST_CASE("at cos = 1 every power is 1, at 0 it is 0", "[ends]") {
  for (const auto name : format_names) {
    const selection asked = choose("power", std::string(name));
    const auto bit = asked.of().make_bit(asked);
    columns in(asked.of().ports(asked), port::role::data);
    columns out;
    in.resize(2000);
    for (std::size_t i = 0; i < 2000; ++i) {
      in[specular::kN].set(i, static_cast<std::int64_t>(i / 2 + 1));
      in[specular::kCos].set(i, i % 2 == 0 ? 0 : std::int64_t{1} << asked.fraction());
    }
    bit->run(in, out);
    for (std::size_t i = 0; i < 2000; ++i) {
      CAPTURE(name, i);
      REQUIRE(out[specular::kBrdf].get(i) == (i % 2 == 0 ? 0 : std::int64_t{1} << asked.fraction()));
    }
  }
}

TEST_CASE("power says what it is", "[words]") {
  const selection small = choose("power", "q8");
  CHECK(small.text() == "device power, format q8, 4 lines for the logarithm, 8 for the power of two");
  // 4 words of 13 and 10 bits, 8 of 13 and 10.
  CHECK(small.of().rom_bits(small) == 4 * 23 + 8 * 23);
  CHECK_THROWS_WITH(choose("power", "q8", {{"coefficient", "exact"}}),
                    "device power has no option --coefficient, expected none");
}
