// SPDX-License-Identifier: Apache-2.0
/// Integer arithmetic of angles for the words of read-only memories. Numbers have 59 fraction bits unless it is said
/// otherwise; each function's error is a few units of 2^-59 relative to its result.
#pragma once

#include "rtl_sysc/devices/word_arithmetic.h"

namespace blysk {

inline constexpr std::uint64_t kUnity59 = std::uint64_t(1) << 59;
inline constexpr std::uint64_t kLogOfTwo59 = 399572145162582989;   // ln 2
inline constexpr std::uint64_t kTwoByPi59 = 366986312910250153;    // 2/pi
inline constexpr std::uint64_t kHalfPi59 = 905502432259640355;     // pi/2
inline constexpr std::uint64_t kRootOfTwo59 = 815238614083298888;  // sqrt 2
inline constexpr std::uint64_t kMillion = 1000000;

/// a / b. \param a  below 2^69   \param b  not 0
constexpr std::uint64_t quotient_59(rom_wide a, std::uint64_t b) {
  return static_cast<std::uint64_t>(((a << 59) + b / 2) / b);
}

/// -ln(q / 10^6), by ln(2) and 2 artanh z = 2 (z + z^3/3 + ...), z <= 1/3.
/// \param q  1..999999
constexpr std::uint64_t log_of_reciprocal(std::uint64_t q) {
  std::uint64_t scaled = q;
  std::uint64_t doublings = 0;
  for (; 2 * scaled <= kMillion; scaled *= 2) ++doublings;
  const std::uint64_t z = quotient_59(kMillion - scaled, kMillion + scaled);
  const std::uint64_t square = unit_product(z, z);
  std::uint64_t power = z;
  std::uint64_t sum = 0;
  for (std::uint64_t j = 1; j < 41; j += 2) {
    sum += power / j;
    power = unit_product(power, square);
  }
  return doublings * kLogOfTwo59 + 2 * sum;
}

/// (1 - e^-t) / t: in (0, 1], 1 at 0. \param t  up to 14
constexpr std::uint64_t decay_ratio(std::uint64_t t) {
  const std::uint64_t halvings = t / kLogOfTwo59;
  const std::uint64_t rest = t - halvings * kLogOfTwo59;
  std::uint64_t ratio = kUnity59;  // 1 - r/2 (1 - r/3 (1 - ...)), r < ln 2
  for (std::uint64_t j = 22; j >= 2; --j) ratio = kUnity59 - unit_product(rest, ratio) / j;
  if (halvings == 0) return ratio;
  const std::uint64_t decayed = (kUnity59 - unit_product(rest, ratio)) >> halvings;  // e^-t
  return quotient_59(kUnity59 - decayed, t);
}

/// asin(sqrt u) / sqrt u = 1 + u/6 + 3 u^2/40 + ...: 1 at 0, pi/2 sqrt(1/2) at 1/2. \param u  in [0, 1/2]
constexpr std::uint64_t arcsine_ratio(std::uint64_t u) {
  std::uint64_t power = kUnity59;  // (2j)! / (4^j j!^2) u^j
  std::uint64_t sum = 0;
  for (std::uint64_t j = 0; j < 64 && power > 0; ++j) {
    sum += power / (2 * j + 1);
    power = unit_product(power, u) * (2 * j + 1) / (2 * j + 2);
  }
  return sum;
}

/// cos(pi/2 place / 2^bits). \param place  0..2^bits - 1   \param bits  1..32
constexpr std::uint64_t cosine_of_place(std::uint64_t place, int bits) {
  const std::uint64_t end = std::uint64_t(1) << bits;
  const bool is_flat = 2 * place <= end;  // up to pi/4; beyond it the sine of what is left
  const std::uint64_t shown = is_flat ? place : end - place;
  const std::uint64_t y = static_cast<std::uint64_t>((rom_wide(kHalfPi59) * shown) >> bits);
  const std::uint64_t square = unit_product(y, y);
  std::uint64_t sum =
      kUnity59;  // 1 - y^2/(1 2) (1 - y^2/(3 4) (...)), or 1 - y^2/(2 3) (1 - y^2/(4 5) (...))
  for (std::uint64_t j = 20; j >= 2; j -= 2) {
    const std::uint64_t divisor = is_flat ? (j - 1) * j : j * (j + 1);
    sum = kUnity59 - unit_product(square, sum) / divisor;
  }
  return is_flat ? sum : unit_product(y, sum);
}

}  // namespace blysk
