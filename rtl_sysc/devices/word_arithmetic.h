// SPDX-License-Identifier: Apache-2.0
/// Integer arithmetic for the words of read-only memories, at compile time.
#pragma once

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

/// x^exponent of a number of [0, 1] with 59 fraction bits; error below exponent 2^-58.
constexpr std::uint64_t unit_power(std::uint64_t x, std::uint64_t exponent) {
  std::uint64_t power = std::uint64_t(1) << 59;
  std::uint64_t square = x;
  for (std::uint64_t rest = exponent; rest > 0; rest >>= 1) {
    if ((rest & 1) != 0) power = unit_product(power, square);
    square = unit_product(square, square);
  }
  return power;
}

/// x 2^-59 rounded to nearest, ties up. \param bits  fraction bits of the result, below 59
constexpr std::int64_t rounded_word(rom_wide x, int bits) {
  return static_cast<std::int64_t>((x + (rom_wide(1) << (58 - bits))) >> (59 - bits));
}

/// numerator / denominator rounded to nearest, ties up. \param bits  fraction bits of the result
constexpr std::int64_t rounded_ratio(rom_wide numerator, rom_wide denominator, int bits) {
  return static_cast<std::int64_t>(((numerator << (bits + 1)) + denominator) / (2 * denominator));
}

}  // namespace blysk
