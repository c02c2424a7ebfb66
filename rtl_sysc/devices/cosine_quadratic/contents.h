// SPDX-License-Identifier: Apache-2.0
/// The words of the read-only memories of [T] fig. 3.1, by integer arithmetic. Exponent 0, what the register of n holds
/// after a reset, has the word that the formula gives.
#pragma once

#include "rtl_sysc/devices/word_arithmetic.h"

#include <array>
#include <cstddef>

namespace blysk {

/// (n + 1)/3, ROM 33, rounded to nearest. \param n  0..1000
constexpr std::int64_t slope_word(std::uint64_t n, int bits) {
  return rounded_ratio(n + 1, 3, bits);
}

/// ROM 9: c^n at the root c = (n - 2)/(n + 1), where the lobe that stands for c^n ends, rounded to nearest. 0 up to n = 2,
/// whose lobe has no root above c = 0; e^-3 in the limit of large n. [T] does not say which limit it means.
/// \param n     0..1000
/// \param bits  up to 40
constexpr std::int64_t limit_word(std::uint64_t n, int bits) {
  if (n <= 2) return 0;
  const rom_wide root = (rom_wide(n - 2) << 59) / (n + 1);
  return rounded_word(unit_power(static_cast<std::uint64_t>(root), n), bits);
}

/// (n + 6)/24.55, [T] (2.26), rounded to nearest. \param n  0..1000
constexpr std::int64_t published_factor_word(std::uint64_t n, int bits) {
  return rounded_ratio((n + 6) * 20, 491, bits);
}

/// (n + 1)/(8 pi), rounded down, so that no word exceeds the factor that keeps the reflectance at or below 1.
/// \param n     0..1000
/// \param bits  up to 40
constexpr std::int64_t safe_factor_word(std::uint64_t n, int bits) {
  const std::uint64_t reciprocal = 733972625820500306;  // 2^64 / (8 pi)
  return static_cast<std::int64_t>((rom_wide(n + 1) * reciprocal) >> (64 - bits));
}

using exponent_table = std::array<std::int64_t, 1001>;

/// What ROM 33 holds.
template <int Bits>
struct slope_words {
  static constexpr exponent_table make() {
    exponent_table all{};
    for (std::size_t n = 0; n < all.size(); ++n) all[n] = slope_word(n, Bits);
    return all;
  }
  static constexpr std::array<exponent_table, 1> words{make()};
};

/// What ROM 9 holds.
template <int Bits>
struct limit_words {
  static constexpr exponent_table make() {
    exponent_table all{};
    for (std::size_t n = 0; n < all.size(); ++n) all[n] = limit_word(n, Bits);
    return all;
  }
  static constexpr std::array<exponent_table, 1> words{make()};
};

/// The published and the safe energy factor.
template <int Bits>
struct factor_words {
  static constexpr exponent_table make_published() {
    exponent_table all{};
    for (std::size_t n = 0; n < all.size(); ++n) all[n] = published_factor_word(n, Bits);
    return all;
  }
  static constexpr exponent_table make_safe() {
    exponent_table all{};
    for (std::size_t n = 0; n < all.size(); ++n) all[n] = safe_factor_word(n, Bits);
    return all;
  }
  static constexpr std::array<exponent_table, 2> words{make_published(), make_safe()};
};

}  // namespace blysk
