// SPDX-License-Identifier: Apache-2.0
/// The words of the prototype's read-only memory, by integer arithmetic.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace blysk {

// NOLINTNEXTLINE(modernize-use-using): __extension__ takes no alias
__extension__ typedef unsigned __int128 rom_wide;

/// floor(sqrt(x)).
constexpr std::uint64_t square_root(rom_wide x) {
  std::uint64_t root = 0;
  for (int bit = 63; bit >= 0; --bit) {
    const std::uint64_t tried = root | (std::uint64_t(1) << bit);
    if (rom_wide(tried) * tried <= x) root = tried;
  }
  return root;
}

/// a b of numbers of [0, 1] with 59 fraction bits, rounded to nearest.
constexpr std::uint64_t unit_product(std::uint64_t a, std::uint64_t b) {
  return static_cast<std::uint64_t>((rom_wide(a) * b + (rom_wide(1) << 58)) >> 59);
}

/// x 2^-59 rounded to `bits` fraction bits.
constexpr std::int64_t rounded_word(rom_wide x, int bits) {
  return static_cast<std::int64_t>((x + (rom_wide(1) << (58 - bits))) >> (59 - bits));
}

/// a of [P] (9), (t^(n-1) - 1) / (t - 1) with t = sqrt((n-1)/n), as n (1 + t) (1 - t^(n-1)), since 1 - t^2 = 1/n.
/// t has 59 fraction bits; its error grows to less than n^2 2^-58 < 2^-38 in a.
/// \param n  1..1000
/// \return   rounded to nearest, with `bits` fraction bits, 1..24; a(1) is its limit 0
constexpr std::int64_t exact_word(std::uint64_t n, int bits) {
  const std::uint64_t one = std::uint64_t(1) << 59;
  const std::uint64_t t = square_root((rom_wide(n - 1) << 118) / n);
  std::uint64_t power = one;  // t^(n-1)
  std::uint64_t square = t;
  for (std::uint64_t rest = n - 1; rest > 0; rest >>= 1) {
    if ((rest & 1) != 0) power = unit_product(power, square);
    square = unit_product(square, square);
  }
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
  const rom_wide thousandths = rom_wide(786) * n + 500;
  return static_cast<std::int64_t>(((thousandths << (bits + 1)) + 1000) / 2000);
}

/// Words with `Bits` fraction bits by their exponents 0..1000; exponent 0, what register 1 holds after a reset, has 0.
template <int Bits>
struct coefficient_words {
  using words = std::array<std::int64_t, 1001>;

  static constexpr words make_exact() {
    words all{};
    for (std::size_t n = 1; n < all.size(); ++n) all[n] = exact_word(n, Bits);
    return all;
  }
  static constexpr words make_derived() {
    words all{};
    for (std::size_t n = 1; n < all.size(); ++n) all[n] = derived_word(n, Bits);
    return all;
  }
  static constexpr words make_published() {
    words all{};
    for (std::size_t n = 1; n < all.size(); ++n) all[n] = published_word(n, Bits);
    return all;
  }

  static constexpr words exact = make_exact();
  static constexpr words derived = make_derived();
  static constexpr words published = make_published();
};

}  // namespace blysk
