// SPDX-License-Identifier: Apache-2.0
// The words of the memories against 50 digits, and what the device says of itself.
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>

#include <fstream>

#include "rtl_sysc/devices/cosine_quadratic/formats.h"
#include "tb/catch.h"
#include "tb/device.h"
#include "tb/visit_format.h"

namespace {

using namespace blysk;
using real50 = boost::multiprecision::cpp_dec_float_50;

/// x * 2^bits rounded to nearest, ties up.
std::int64_t rounded(const real50& x, int bits) {
  return static_cast<std::int64_t>(floor(ldexp(x, bits) + real50(1) / 2));
}

/// c^n at the root, by its logarithm: another way than the words'.
real50 limit(int n) {
  if (n <= 2) return 0;
  return exp(n * log(real50(n - 2) / (n + 1)));
}

std::string refusal(const std::map<std::string, std::string>& options) {
  try {
    choose("cosine-quadratic", "q8", options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the words are their formulas, rounded, for every exponent and width", "[contents]") {
  const real50 eight_pi = 8 * boost::math::constants::pi<real50>();
  for (int n = 0; n <= 1000; ++n) {
    const real50 at_root = limit(n);
    for (int bits = 1; bits <= 26; ++bits) {
      const auto exponent = static_cast<std::uint64_t>(n);
      CAPTURE(n, bits);
      REQUIRE(slope_word(exponent, bits) == rounded(real50(n + 1) / 3, bits));
      REQUIRE(limit_word(exponent, bits) == rounded(at_root, bits));
      REQUIRE(published_factor_word(exponent, bits) == rounded((n + 6) / real50("24.55"), bits));
      REQUIRE(safe_factor_word(exponent, bits) ==
              static_cast<std::int64_t>(floor(ldexp((n + 1) / eight_pi, bits))));
    }
  }
}

TEST_CASE("the words that hand arithmetic gives", "[contents]") {
  CHECK(slope_word(0, 8) == 85);             // 256/3 = 85.33, after a reset
  CHECK(slope_word(1, 8) == 171);            // 170.67
  CHECK(slope_word(2, 8) == 256);            // 1
  CHECK(slope_word(1000, 8) == 85419);       // 256256/3 = 85418.67
  CHECK(limit_word(2, 16) == 0);             // the root lies at c = 0
  CHECK(limit_word(3, 8) == 4);              // (1/4)^3 = 1/64
  CHECK(limit_word(1000, 16) == 3258);       // (1 - 3/1001)^1000 = e^-3.0015 = 0.049712, times 65536 = 3257.9
  CHECK(published_factor_word(1, 8) == 73);  // 7/24.55 * 256 = 72.99
  CHECK(published_factor_word(1000, 8) == 10490);  // 1006/24.55 * 256 = 10490.26
  CHECK(safe_factor_word(1, 8) == 20);             // 2/(8 pi) * 256 = 20.37
  CHECK(safe_factor_word(1000, 8) == 10196);       // 1001/(8 pi) * 256 = 10196.1
}

TEST_CASE("the device says how large its memories are", "[contents]") {
  const auto bits = [](const std::string& format, const std::map<std::string, std::string>& options) {
    const selection asked = choose("cosine-quadratic", format, options);
    return asked.of().rom_bits(asked);
  };
  CHECK(bits("q8", {}) == 1001 * 17);
  CHECK(bits("q8", {{"gating", "published"}}) == 1001 * (17 + 4));
  CHECK(bits("q8", {{"energy", "safe"}}) == 1001 * (17 + 16));
  CHECK(bits("q24", {}) == 1001 * 33);
}

TEST_CASE("the options of cosine-quadratic in words", "[contents]") {
  CHECK(choose("cosine-quadratic", "q8").text() ==
        "device cosine-quadratic, format q8, gated by the sign of adder 8, constants weigh unity");
  CHECK(choose("cosine-quadratic", "q8", {{"gating", "published"}, {"constants", "published"}}).text() ==
        "device cosine-quadratic, format q8, gated by comparator 11 as published, constants weigh one LSB as "
        "published");
  CHECK(choose("cosine-quadratic", "q8", {{"energy", "safe"}}).text() ==
        "device cosine-quadratic, format q8, gated by the sign of adder 8, constants weigh unity, energy "
        "factor "
        "safe");
}

TEST_CASE("an energy factor goes with the gated lobe alone", "[contents]") {
  const std::string expected =
      " scales a lobe that ends at its root, expected --gating sign and --constants unity with it";
  for (const char* option : {"gating", "constants"}) {
    for (const char* factor : {"published", "safe"})
      CHECK(refusal({{"energy", factor}, {option, "published"}}) == "--energy " + (factor + expected));
  }
  CHECK(refusal({{"energy", "safe"}}).empty());
}

TEST_CASE("no net of any format of cosine-quadratic overflows", "[contents]") {
  // The assertions are static: that this compiles is the test.
  using enum root_gate;
  using enum constant_weight;
  for (const auto name : format_names) {
    CHECK(visit_format(std::string(name), []<class Q>() {
      return cosine_quadratic_formats<Q, sign, unity, false>::no_overflow() &&
             cosine_quadratic_formats<Q, sign, unity, true>::no_overflow() &&
             cosine_quadratic_formats<Q, limit, unity, false>::no_overflow() &&
             cosine_quadratic_formats<Q, sign, lsb, false>::no_overflow() &&
             cosine_quadratic_formats<Q, limit, lsb, false>::no_overflow();
    }));
  }
}
