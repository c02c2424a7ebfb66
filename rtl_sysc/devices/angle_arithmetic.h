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

/// cos y for first = 1: 1 - y^2/(1 2) (1 - y^2/(3 4) (...)); sin(y) / y for first = 2: 1 - y^2/(2 3) (1 - y^2/(4 5) (...)).
/// \param y  in [0, pi/4]
constexpr std::uint64_t sine_series(std::uint64_t y, std::uint64_t first) {
  const std::uint64_t square = unit_product(y, y);
  std::uint64_t sum = kUnity59;
  for (std::uint64_t j = first + 20; j > first; j -= 2)
    sum = kUnity59 - unit_product(square, sum) / ((j - 2) * (j - 1));
  return sum;
}

/// cos(pi/2 place / 2^bits). \param place  0..2^bits - 1   \param bits  1..32
constexpr std::uint64_t cosine_of_place(std::uint64_t place, int bits) {
  const std::uint64_t end = std::uint64_t(1) << bits;
  const bool is_flat = 2 * place <= end;  // up to pi/4; beyond it the sine of what is left
  const std::uint64_t shown = is_flat ? place : end - place;
  const std::uint64_t y = static_cast<std::uint64_t>((rom_wide(kHalfPi59) * shown) >> bits);
  return is_flat ? sine_series(y, 1) : unit_product(y, sine_series(y, 2));
}

/// 2 sin^2(pi/4 x) / x, 0 at 0. \param x  up to 31
constexpr std::uint64_t squared_sine_ratio(std::uint64_t x) {
  if (x == 0) return 0;
  const std::uint64_t rest = x % (4 * kUnity59);  // the square has the period 4, and is even
  const std::uint64_t folded = rest <= 2 * kUnity59 ? rest : 4 * kUnity59 - rest;
  const bool is_flat = folded <= kUnity59;  // up to pi/4; beyond it the cosine of what is left
  const std::uint64_t y = unit_product(is_flat ? folded : 2 * kUnity59 - folded, kHalfPi59) / 2;
  const std::uint64_t sine = unit_product(y, sine_series(y, 2));
  if (x <= kUnity59) return 2 * unit_product(sine, quotient_59(sine, x));  // keeps its digits for small x
  const std::uint64_t square = unit_product(sine, sine);
  return quotient_59(2 * (is_flat ? square : kUnity59 - square), x);
}

/// Integral from 0 to pi/2 of cos^power(y) sin(b y) dy. cos^power as a sum of cosines, and the products as sums of sines:
/// the sum over j of C(power, j) 2^-power 2 sin^2(pi/4 x)/x, x = b + power - 2 j.
/// \param power  1..15   \param b  up to 2
constexpr std::uint64_t lobe_moment(std::uint64_t power, std::uint64_t b) {
  rom_wide above = 0;
  rom_wide below = 0;         // of negative x, for which a term is negative
  std::uint64_t choices = 1;  // C(power, j)
  for (std::uint64_t j = 0; j <= power; ++j) {
    const std::uint64_t from_b = 2 * j <= power ? (power - 2 * j) * kUnity59 : (2 * j - power) * kUnity59;
    if (2 * j <= power) {
      above += rom_wide(choices) * squared_sine_ratio(b + from_b);
    } else if (from_b <= b) {
      above += rom_wide(choices) * squared_sine_ratio(b - from_b);
    } else {
      below += rom_wide(choices) * squared_sine_ratio(from_b - b);
    }
    choices = choices * (power - j) / (j + 1);
  }
  return static_cast<std::uint64_t>((above - below + (rom_wide(1) << (power - 1))) >> power);
}

}  // namespace blysk
