// SPDX-License-Identifier: Apache-2.0
// The words of the memory against 50 digits, and what the device says of itself.
#include <boost/multiprecision/cpp_dec_float.hpp>

#include <fstream>
#include <regex>
#include <string>

#include "rtl_sysc/devices/quadratic_rom/quadratic_rom.h"
#include "tb/catch.h"
#include "tb/device.h"
#include "tb/golden/coefficient.h"
#include "tb/visit_format.h"

namespace {

using namespace blysk;
using real50 = boost::multiprecision::cpp_dec_float_50;

/// x * 2^bits rounded to nearest, ties up.
std::int64_t rounded(const real50& x, int bits) {
  return static_cast<std::int64_t>(floor(ldexp(x, bits) + real50(1) / 2));
}

/// (t^(n-1) - 1) / (t - 1) by its sum 1 + t + ... + t^(n-2): another way than the words' and the golden function's.
real50 sum_of_powers(int n) {
  const real50 t = sqrt(real50(n - 1) / n);
  real50 sum = 0;
  real50 power = 1;
  for (int k = 0; k <= n - 2; ++k) {
    sum += power;
    power *= t;
  }
  return sum;
}

}  // namespace

TEST_CASE("the words are the three lines, rounded, for every exponent and width", "[contents]") {
  for (int n = 1; n <= 1000; ++n) {
    const real50 exact = sum_of_powers(n);
    const real50 derived = golden::coefficient_slope<real50>() * n - real50(1) / 2;
    const real50 published = real50(786) * n / 1000 + real50(1) / 2;
    for (int bits = 1; bits <= 24; ++bits) {
      const auto exponent = static_cast<std::uint64_t>(n);
      CAPTURE(n, bits);
      REQUIRE(exact_word(exponent, bits) == rounded(exact, bits));
      REQUIRE(derived_word(exponent, bits) == rounded(derived, bits));
      REQUIRE(published_word(exponent, bits) == rounded(published, bits));
    }
  }
}

TEST_CASE("the words that hand arithmetic gives", "[contents]") {
  CHECK(exact_word(1, 8) == 0);                  // the limit of (9)
  CHECK(exact_word(2, 8) == 256);                // 1
  CHECK(exact_word(3, 20) == 1904735);           // 1 + sqrt(2/3) = 1.816496580927726
  CHECK(derived_word(1, 8) == 73);               // 0.28694 * 256 = 73.456
  CHECK(published_word(1, 8) == 329);            // 1.286 * 256 = 329.2
  CHECK(published_word(1000, 20) == 824705024);  // 786.5 * 2^20
}

TEST_CASE("exponent 0, what register 1 holds after a reset, has the word 0", "[contents]") {
  for (const auto& line : coefficient_words<8>::words) CHECK(line[0] == 0);
}

TEST_CASE("reference.v holds the words with 34 fraction bits", "[contents]") {
  std::ifstream file(BLYSK_DEVICE_FOLDER "/reference.v");
  const std::regex line(R"( +(\d+): word = 44'd(\d+);)");
  int count = 0;
  for (std::string text; std::getline(file, text);) {
    std::smatch found;
    if (!std::regex_match(text, found, line)) continue;
    const int n = std::stoi(found[1]);
    CAPTURE(n);
    REQUIRE(std::stoll(found[2]) == rounded(sum_of_powers(n), 34));
    ++count;
  }
  CHECK(count == 1000);
}

TEST_CASE("the device says how large its memory is", "[contents]") {
  const selection small = choose("quadratic-rom", "q8");
  CHECK(small.of().rom_bits(small) == 18'000);  // at least 2 KB, as [P] has it
  const selection large = choose("quadratic-rom", "q24");
  CHECK(large.of().rom_bits(large) == 30'000);
  CHECK(small.text() ==
        "device quadratic-rom, format q8, memory of 1000 words of 18 bits, coefficient exact, BRDF clamped "
        "to [0, 1]");
  CHECK_THROWS_WITH(
      choose("quadratic-rom", "q8", {{"constant", "101"}}),
      "device quadratic-rom has no option --constant, expected --coefficient, --rom, --as-published");
  CHECK_THROWS_WITH(choose("quadratic-rom", "q8", {{"rom", "flash"}}),
                    "--rom is flash, expected logic, clocked");
}

TEST_CASE("no net of any format of the prototype overflows", "[contents]") {
  // The assertions are static: that this compiles is the test.
  for (const auto name : format_names) {
    CHECK(visit_format(std::string(name), []<class Q>() {
      return quadratic_rom_formats<Q, negative_lobe::clamped>::no_overflow() &&
             quadratic_rom_formats<Q, negative_lobe::as_published>::no_overflow();
    }));
  }
}
