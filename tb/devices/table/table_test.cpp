// SPDX-License-Identifier: Apache-2.0
// The words of the memories against 50 digits, the distance of e^-t from cos^n, and what the device says of itself.
#include <boost/multiprecision/cpp_dec_float.hpp>

#include <algorithm>
#include <cmath>

#include "rtl_sysc/devices/table/formats.h"
#include "tb/catch.h"
#include "tb/device.h"
#include "tb/specular/specular.h"
#include "tb/specular/test/lobe_ends.h"
#include "tb/visit_format.h"

namespace {

using namespace blysk;
using real50 = boost::multiprecision::cpp_dec_float_50;

/// x * 2^bits rounded to nearest, ties up.
std::int64_t rounded(const real50& x, int bits) {
  return static_cast<std::int64_t>(floor(ldexp(x, bits) + real50(1) / 2));
}

/// How far e^(-n (u + weight u^2)), u = 1 - c, lies from c^n at most where c^n is `level` or more, at 4001 cosines down to
/// where c^n is 1e-9.
double distance(double n, double weight, double level) {
  const double lowest = std::pow(1e-9, 1 / n);
  double largest = 0;
  for (int i = 0; i <= 4000; ++i) {
    const double c = 1 - (1 - (n < 6 ? 0 : lowest)) * i / 4000;
    const double power = std::pow(c, n);
    if (power < level) break;
    const double u = 1 - c;
    largest = std::max(largest, std::fabs(std::exp(-n * (u + weight * u * u)) - power));
  }
  return largest;
}

}  // namespace

TEST_CASE("the words are e^(-i/32) and its changes, rounded, for every width", "[contents]") {
  for (int i = 0; i < 256; ++i) {
    const real50 exact = exp(real50(-i) / 32);
    for (int bits = 1; bits <= 24; ++bits) {
      CAPTURE(i, bits);
      REQUIRE(decay_word(static_cast<std::uint64_t>(i), bits) == rounded(exact, bits));
    }
  }
  for (const auto name : format_names) {
    visit_format(std::string(name), []<class Q>() {
      const auto& words = table_formats<Q>::contents::words;
      const int bits = table_formats<Q>::word_bits;
      for (int i = 0; i < 256; ++i) {
        CAPTURE(i, bits);
        const auto at = static_cast<std::size_t>(i);
        const std::int64_t next = i < 255 ? rounded(exp(real50(-i - 1) / 32), bits) : 0;
        REQUIRE(words[0][at] == rounded(exp(real50(-i) / 32), bits));
        REQUIRE(words[1][at] == next - words[0][at]);
      }
      return 0;
    });
  }
}

TEST_CASE("the words that hand arithmetic gives", "[contents]") {
  const auto& words = decay_words<11>::words;
  CHECK(words[0][0] == 2048);
  CHECK(words[1][0] == -63);   // 1 - e^(-1/32) is 0.030767, times 2048 63.01
  CHECK(words[0][32] == 753);  // 2048/e is 753.42
  CHECK(words[0][255] == 1);   // 2048 e^(-7.96875) is 0.709
  CHECK(words[1][255] == -1);  // the lobe ends at 0
}

TEST_CASE("with u^2/2 one memory of e^-t stands for cos^n better than without, for every n", "[argument]") {
  for (int n = 1; n <= 1000; ++n) {
    CAPTURE(n);
    for (const double level : {0.0, 0.56}) CHECK(distance(n, 0.5, level) < distance(n, 0, level));
  }
  // The figures of docs/devices/table.md.
  CHECK(distance(1, 0, 0) == Approx(0.3679).margin(5e-5));
  CHECK(distance(1, 0.5, 0) == Approx(0.2231).margin(5e-5));
  CHECK(distance(10, 0, 0) == Approx(0.0280).margin(5e-5));
  CHECK(distance(10, 0.5, 0) == Approx(0.00374).margin(5e-6));
  CHECK(distance(100, 0, 0) == Approx(0.00272).margin(5e-6));
  CHECK(distance(100, 0.5, 0) == Approx(0.0000438).margin(5e-8));
}

TEST_CASE("the peak is 1 for every n, and from t = 8 on the lobe is 0", "[ends]") {
  for (const auto name : format_names) {
    const selection asked = choose("table", std::string(name));
    const std::int64_t one = std::int64_t{1} << asked.fraction();
    for (const specular::lobe_ends& each : specular::lobe_ends_of(asked)) {
      CAPTURE(name, each.n);
      REQUIRE(each.at_peak == one);
      if (!each.has_root) continue;
      REQUIRE(each.at_root == 0);
      REQUIRE(each.at_zero == 0);
    }
  }
}

TEST_CASE("table says what it is", "[words]") {
  const selection small = choose("table", "q8");
  CHECK(small.text() == "device table, format q8, a memory of 256 lines");
  CHECK(small.of().rom_bits(small) == 256 * (12 + 7));
  const selection large = choose("table", "q24");
  CHECK(large.of().rom_bits(large) == 256 * (20 + 15));
  CHECK_THROWS_WITH(choose("table", "q8", {{"coefficient", "exact"}}),
                    "device table has no option --coefficient, expected none");
}
