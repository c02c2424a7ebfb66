// SPDX-License-Identifier: Apache-2.0
// The words of the memories of `angle` against 50 digits.
#include <boost/multiprecision/cpp_dec_float.hpp>

#include <cstdint>
#include <vector>

#include "rtl_sysc/devices/angle/formats.h"
#include "tb/catch.h"
#include "tb/golden/pi.h"

namespace {

using namespace blysk;
using real50 = boost::multiprecision::cpp_dec_float_50;

/// x * 2^bits rounded to nearest, ties up.
std::int64_t rounded(const real50& x, int bits) {
  return static_cast<std::int64_t>(floor(ldexp(x, bits) + real50(1) / 2));
}

/// acos(Q^(1/n)) as it stands, with 50 digits.
real50 angle_of(std::uint64_t millionths, int n) {
  return acos(pow(real50(millionths) / 1000000, real50(1) / n));
}

}  // namespace

TEST_CASE("the words of ROM 2 are 2/pi acos(Q^(1/k)) / acos(Q^(1/n)), rounded", "[contents]") {
  const real50 two_by_pi = 2 / golden::pi<real50>();
  // [A]'s Q, and its neighbours that strain the arithmetic.
  constexpr std::uint64_t kLevels[] = {1,      100000, 200000, 300000, 400000, 500000,
                                       600000, 700000, 800000, 900000, 999999};
  for (const std::uint64_t q : kLevels) {
    std::vector<real50> angles(1001);
    for (int n = 1; n <= 1000; ++n) angles[static_cast<std::size_t>(n)] = angle_of(q, n);
    for (const int k : {1, 2, 3, 4, 5, 15}) {
      const angle_factor factor(q, static_cast<std::uint64_t>(k));
      for (int n = 1; n <= 1000; ++n) {
        const real50 exact = n <= k ? two_by_pi
                                    : real50(two_by_pi * angles[static_cast<std::size_t>(k)] /
                                             angles[static_cast<std::size_t>(n)]);
        for (const int bits : {angle_formats<q8>::factor_bits, angle_formats<q24>::factor_bits, 30}) {
          CAPTURE(q, k, n, bits);
          REQUIRE(factor.word(static_cast<std::uint64_t>(n), bits) == rounded(exact, bits));
        }
      }
    }
  }
}

TEST_CASE("the words of ROM 1 are powers of the cosine, rounded", "[contents]") {
  for (const int address : {angle_formats<q8>::address_bits, angle_formats<q24>::address_bits}) {
    const std::uint64_t size = std::uint64_t{1} << address;
    for (std::uint64_t place = 0; place < size; ++place) {
      const real50 cosine = cos(golden::pi<real50>() * place / (2 * size));
      real50 power = 1;
      for (std::uint64_t k = 1; k <= kMostPowers; ++k) {
        power *= cosine;
        for (const int bits : {8, 16, 24}) {
          CAPTURE(address, place, k, bits);
          REQUIRE(cosine_word(place, address, k, bits) == rounded(power, bits));
        }
      }
    }
  }
}

TEST_CASE("the words that hand arithmetic gives", "[contents]") {
  const angle_factor half(500000, 1);
  CHECK(half.word(1, 13) == 5215);  // 2/pi 2^13 = 5215.19
  CHECK(half.word(2, 13) == 6954);  // acos(1/2) / acos(sqrt(1/2)) = (pi/3) / (pi/4): 2/pi 4/3 2^13 = 6953.6
  CHECK(cosine_word(0, 10, 15, 24) == 1 << 24);
  CHECK(cosine_word(512, 10, 2, 24) == 1 << 23);  // cos^2 of 45 degrees
  CHECK(cosine_word(512, 10, 4, 8) == 64);
}

TEST_CASE("part 0 holds cos^k, part m cos^m, and nothing lies beyond the last part", "[contents]") {
  constexpr int kAddress = 9;
  std::vector<std::int64_t> words(std::size_t{5} << kAddress, -1);
  fill_powers(words, 4, kAddress, 12);
  for (std::size_t place = 0; place < 512; ++place) {
    CHECK(words[place] == cosine_word(place, kAddress, 4, 12));
    for (std::size_t part = 1; part < 4; ++part)
      CHECK(words[part * 512 + place] == cosine_word(place, kAddress, part, 12));
    CHECK(words[4 * 512 + place] == -1);
  }
}
