// SPDX-License-Identifier: Apache-2.0
/// The words of the prototype's read-only memory, by integer arithmetic.
#pragma once

#include "rtl_sysc/devices/word_arithmetic.h"

#include <array>
#include <cstddef>

namespace blysk {

/// a of [P] (9), (t^(n-1) - 1) / (t - 1) with t = sqrt((n-1)/n), as n (1 + t) (1 - t^(n-1)), since 1 - t^2 = 1/n.
/// t has 59 fraction bits; its error grows to less than n^2 2^-58 < 2^-38 in a.
/// \param n  1..1000
/// \return   rounded to nearest, with `bits` fraction bits, 1..24; a(1) is its limit 0
constexpr std::int64_t exact_word(std::uint64_t n, int bits) {
  const std::uint64_t one = std::uint64_t(1) << 59;
  const std::uint64_t t = square_root((rom_wide(n - 1) << 118) / n);
  const std::uint64_t power = unit_power(t, n - 1);
  // n (1 + t) < 2^11 with 59 fraction bits, times 59 fraction bits: the first factor is cut to 47 bits.
  const rom_wide factor = (rom_wide(n) * (one + t)) >> 12;
  return rounded_word((factor * (one - power)) >> 47, bits);
}

/// S n - 1/2, S = 2(1 - e^(-1/2)), rounded to nearest. \param n  1..1000
constexpr std::int64_t derived_word(std::uint64_t n, int bits) {
  const std::uint64_t slope = 453639263820774145;  // S * 2^59
  return rounded_word(rom_wide(n) * slope - (rom_wide(1) << 58), bits);
}

/// 0.786 n + 0.5, [P] (10), rounded to nearest. \param n  1..1000
constexpr std::int64_t published_word(std::uint64_t n, int bits) {
  return rounded_ratio(rom_wide(786) * n + 500, 1000, bits);
}

/// Words with `Bits` fraction bits by their exponents 0..1000; exponent 0, what register 1 holds after a reset, has 0.
template <int Bits>
struct coefficient_words {
  using table = std::array<std::int64_t, 1001>;

  static constexpr table make_exact() {
    table all{};
    for (std::size_t n = 1; n < all.size(); ++n) all[n] = exact_word(n, Bits);
    return all;
  }
  static constexpr table make_derived() {
    table all{};
    for (std::size_t n = 1; n < all.size(); ++n) all[n] = derived_word(n, Bits);
    return all;
  }
  static constexpr table make_published() {
    table all{};
    for (std::size_t n = 1; n < all.size(); ++n) all[n] = published_word(n, Bits);
    return all;
  }

  /// (9), the derived and the published line.
  static constexpr std::array<table, 3> words{make_exact(), make_derived(), make_published()};
};

}  // namespace blysk
