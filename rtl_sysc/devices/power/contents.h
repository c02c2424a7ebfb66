// SPDX-License-Identifier: Apache-2.0
/// The words of the read-only memories of power, by integer arithmetic: lines that stand for a curve, one for each segment,
/// as its value at the segment's begin and its change until the end. A line lies below the chord by half of what the chord
/// is off in the middle, so that its largest error is half the chord's.
#pragma once

#include "rtl_sysc/devices/word_arithmetic.h"

#include <array>
#include <cstddef>

namespace blysk {

/// log2(1 + 1/m) with 62 fraction bits, as 2/ln 2 artanh(1/(2m + 1)); error below 2^-58. \param m  8 or more
constexpr std::uint64_t log_of_step(std::uint64_t m) {
  const std::uint64_t t = (std::uint64_t(1) << 62) / (2 * m + 1);
  const std::uint64_t square = static_cast<std::uint64_t>((rom_wide(t) * t) >> 62);
  std::uint64_t sum = 0;
  std::uint64_t power = t;
  for (std::uint64_t divisor = 1; power > 0; divisor += 2) {
    sum += power / divisor;
    power = static_cast<std::uint64_t>((rom_wide(power) * square) >> 62);
  }
  const std::uint64_t two_over_ln2 = 13306513097844322492U;  // 2/ln 2 * 2^62
  return static_cast<std::uint64_t>((rom_wide(sum) * two_over_ln2) >> 62);
}

/// (1 - log2(1 + f))/(1 - f), which is -log2(1 - v/2)/v at the distance v = 1 - f, at v = j 2^-Bits for all j;
/// 62 fraction bits. Its limit at v = 0 is 1/(2 ln 2). Relative error below 2^(Bits - 58).
template <int Bits>
constexpr std::array<std::uint64_t, (std::size_t(1) << Bits) + 1> log_ratios() {
  constexpr std::uint64_t count = std::uint64_t(1) << Bits;
  std::array<std::uint64_t, count + 1> all{};
  all[0] = 3326628274461080623;  // 1/(2 ln 2) * 2^62
  std::uint64_t sum = 0;
  for (std::uint64_t j = 1; j <= count; ++j) {
    sum += log_of_step(2 * count - j);
    all[j] = static_cast<std::uint64_t>((rom_wide(sum) << Bits) / j);
  }
  return all;
}

/// 2^-(j 2^-Bits + shift) for j in 0..2^Bits, with 59 fraction bits; error below 2^-54.
/// \param shift_bits  shift = 2^-shift_bits
template <int Bits>
constexpr std::array<std::uint64_t, (std::size_t(1) << Bits) + 1> powers_of_half(int shift_bits) {
  constexpr std::size_t count = std::size_t(1) << Bits;
  std::array<std::uint64_t, count + 1> all{};
  // Roots of 1/2: [i] is 2^-(2^-i).
  std::array<std::uint64_t, 60> roots{};
  roots[0] = std::uint64_t(1) << 58;
  for (std::size_t i = 1; i < roots.size(); ++i) roots[i] = square_root(rom_wide(roots[i - 1]) << 59);
  all[0] = roots[static_cast<std::size_t>(shift_bits)];
  for (std::size_t bit = 0; bit <= Bits; ++bit) {
    const std::size_t step = std::size_t(1) << bit;
    for (std::size_t j = 0; j < step && j + step <= count; ++j)
      all[j + step] = unit_product(all[j], roots[Bits - bit]);
  }
  return all;
}

/// A line for each of 2^SegmentBits segments of a falling curve, of which the values at the segments' ends and middles are
/// given: begins, and changes (negative), each rounded to nearest.
/// \tparam SegmentBits   logarithm of their number
/// \tparam BeginsAtLast  the values stand in reverse
/// \param value_bits     fraction bits of the values
/// \param word_bits      of the words
/// \param half_unit      fraction bits of a number whose half is added to the begins: cut to them, the lines are rounded
template <int SegmentBits, bool BeginsAtLast, std::size_t Nodes>
constexpr auto lines(const std::array<std::uint64_t, Nodes>& values, int value_bits, int word_bits,
                     int half_unit) {
  constexpr std::size_t count = std::size_t(1) << SegmentBits;
  static_assert(Nodes == 2 * count + 1);
  std::array<std::array<std::int64_t, count>, 2> all{};
  for (std::size_t i = 0; i < count; ++i) {
    const rom_wide first = values[BeginsAtLast ? 2 * (count - i) : 2 * i];
    const rom_wide middle = values[BeginsAtLast ? 2 * (count - i) - 1 : 2 * i + 1];
    const rom_wide last = values[BeginsAtLast ? 2 * (count - i) - 2 : 2 * i + 2];
    // first - ((first + last)/2 - middle)/2, times 4
    const rom_wide begin =
        4 * first - (first + last - 2 * middle) + (rom_wide(4) << (value_bits - half_unit - 1));
    const int dropped = value_bits - word_bits;
    all[0][i] = static_cast<std::int64_t>((begin + (rom_wide(1) << (dropped + 1))) >> (dropped + 2));
    all[1][i] = -static_cast<std::int64_t>((first - last + (rom_wide(1) << (dropped - 1))) >> dropped);
  }
  return all;
}

/// Lines of (1 - log2(1 + f))/(1 - f) over f in [0, 1): [0] begins, [1] changes.
template <int SegmentBits, int WordBits, int CutBits>
struct log_ratio_words {
  // The table goes by 1 - f.
  static constexpr auto words =
      lines<SegmentBits, true>(log_ratios<SegmentBits + 1>(), 62, WordBits, CutBits);
};

/// Lines of 2^-x over x in [0, 1), where the number cut to x lies half a unit of 2^-PlaceBits above it: [0] begins, [1]
/// changes.
template <int SegmentBits, int WordBits, int CutBits, int PlaceBits>
struct power_words {
  static constexpr auto words =
      lines<SegmentBits, false>(powers_of_half<SegmentBits + 1>(PlaceBits + 1), 59, WordBits, CutBits);
};

}  // namespace blysk
