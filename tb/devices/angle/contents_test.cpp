// SPDX-License-Identifier: Apache-2.0
// The words of the memories of `angle` against 50 digits.
#include <boost/multiprecision/cpp_dec_float.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "rtl_sysc/devices/angle/formats.h"
#include "tb/catch.h"
#include "tb/golden/angle.h"
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

TEST_CASE("the exact and the safe factors are those of quadratures, rounded", "[contents]") {
  constexpr std::uint64_t kLevels[] = {1, 100000, 400000, 500000, 900000, 999999};
  for (const std::uint64_t q : kLevels) {
    for (const int k : {1, 2, 3, 5, 15}) {
      const angle_factor factor(q, static_cast<std::uint64_t>(k));
      for (int n = 1; n <= 1000; ++n) {
        const double level = static_cast<double>(q) / 1e6;
        const double power = std::min(k, n);
        const double exact = golden::angle_coefficient_exact<double>(n, power, level);
        const double safe = golden::angle_coefficient_safe<double>(n, power, level);
        for (const int bits : {angle_formats<q8>::energy_bits, 24}) {
          const double unit = std::ldexp(1, bits);
          // The quadrature's roundings, below 10^-12 of a factor of at most 279.
          const double slack = 3e-10 * unit;
          const auto word = [&](angle_energy which) {
            return static_cast<double>(factor.energy_word(which, static_cast<std::uint64_t>(n), bits));
          };
          CAPTURE(q, k, n, bits);
          REQUIRE(std::abs(word(angle_energy::exact) - exact * unit) <= 0.5 + slack);
          REQUIRE(word(angle_energy::safe) <= safe * unit + slack);
          REQUIRE(word(angle_energy::safe) > safe * unit - 1 - slack);
        }
      }
    }
  }
}

TEST_CASE("the published factors are [A]'s formulas, rounded", "[contents]") {
  for (const int percent : {10, 20, 25, 30, 40, 50, 60, 75, 90}) {
    const real50 level = real50(percent) / 100;
    for (int k = 1; k <= 5; ++k) {
      const auto q = static_cast<std::uint64_t>(percent) * 10000;
      REQUIRE(is_fitted(q, static_cast<std::uint64_t>(k)));
      std::vector<std::int64_t> words(1001);
      fill_energy(words, angle_energy::published, q, static_cast<std::uint64_t>(k), 19);
      for (int n = k + 1; n <= 1000; ++n) {
        const real50 value =
            percent <= 40 ? real50("0.608") * n * (level - real50("0.193")) / (2 * level + 2 * k) +
                                real50("0.161") * n + real50("0.284")
                          : real50("0.743") * level * (real50("0.167") * n - real50("0.0133") * k * n) / k +
                                real50("0.167") * n + real50("0.245");
        CAPTURE(percent, k, n);
        REQUIRE(words[static_cast<std::size_t>(n)] == rounded(value, 19));
      }
      // Up to k, where the fit does not hold, the lobe is cos^n: the exact factor is (n + 2)/(2 pi).
      for (int n = 1; n <= k; ++n)
        REQUIRE(words[static_cast<std::size_t>(n)] == rounded((n + 2) / (2 * golden::pi<real50>()), 19));
      REQUIRE(words[0] == 0);
    }
  }
  constexpr std::uint64_t kOutside[] = {99999, 400001, 450000, 499999, 900001};
  for (const std::uint64_t q : kOutside) CHECK_FALSE(is_fitted(q, 1));
  CHECK_FALSE(is_fitted(500000, 6));
  CHECK(is_fitted(500000, 5));
}

TEST_CASE("factors that the article prints, and those of cos^n", "[contents]") {
  // [A] fig. 4: Q = 0.5, k = 1, three decimals.
  const angle_factor half(500000, 1);
  const auto thousandths = [&](std::uint64_t n) {
    return std::lround(
        std::ldexp(1000.0 * static_cast<double>(half.energy_word(angle_energy::exact, n, 30)), -30));
  };
  CHECK(thousandths(1) == 477);
  CHECK(thousandths(3) == 880);
  CHECK(thousandths(10) == 2410);
  CHECK(thousandths(100) == 22255);
  CHECK(thousandths(1000) == 220765);
  // cos^n: 1/(8 pi) times n + 1, cut. 2^24/(8 pi) = 667544.2.
  const angle_factor fifteenth(300000, 15);
  CHECK(fifteenth.energy_word(angle_energy::safe, 1, 24) == 1335088);
  CHECK(fifteenth.energy_word(angle_energy::safe, 15, 24) == 10680707);
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
