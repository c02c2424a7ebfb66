// SPDX-License-Identifier: Apache-2.0
/// The words of the two read-only memories of UA 71489 with the function of [A], by integer arithmetic at elaboration.
#pragma once

#include "rtl_sysc/devices/angle_arithmetic.h"

#include <array>
#include <cstddef>

namespace blysk {

/// Largest k of [A] that the four outputs of the decoder leave room for.
inline constexpr int kMostPowers = 15;

/// The factor of the angle, acos(Q^(1/k)) / acos(Q^(1/n)), for one Q and k.
///
/// With t = -ln(Q)/n, acos(Q^(1/n)) = 2 asin(sqrt((1 - e^-t)/2)) = 2 sqrt(u) h(u), u = (1 - e^-t)/2 = t g(t)/2. The factor
/// is sqrt(n g_k / (k g_n)) h_k / h_n: all of them keep their digits, however large n and however close to 1 Q is.
class angle_factor {
 public:
  /// \param q  10^6 Q, 1..999999   \param k  1..kMostPowers
  constexpr angle_factor(std::uint64_t q, std::uint64_t k)
      : log_(log_of_reciprocal(q)),
        k_(k),
        decay_(decay_ratio(log_ / k)),
        arc_(arcsine_ratio(level(log_ / k))) {}

  /// 2/pi times the factor, rounded to nearest. For n <= k the factor is 1.
  /// \param n     1..1000
  /// \param bits  up to 40
  constexpr std::int64_t word(std::uint64_t n, int bits) const {
    rom_wide scaled = rom_wide(kTwoByPi59) << 58;  // 117 fraction bits
    if (n > k_) {
      const std::uint64_t t = log_ / n;
      const rom_wide square = ((rom_wide(n) * decay_) << 58) / (rom_wide(k_) * decay_ratio(t));
      const std::uint64_t root = square_root(square << 58);  // 58 fraction bits
      const rom_wide factor = rom_wide(root) * arc_ / arcsine_ratio(level(t));
      scaled = factor * kTwoByPi59;
    }
    return static_cast<std::int64_t>((scaled + (rom_wide(1) << (116 - bits))) >> (117 - bits));
  }

 private:
  static constexpr std::uint64_t level(std::uint64_t t) { return unit_product(t, decay_ratio(t)) / 2; }

  std::uint64_t log_;  // -ln Q
  std::uint64_t k_;
  std::uint64_t decay_, arc_;  // g and h at n = k
};

/// cos^power(pi/2 place / 2^address_bits), rounded to nearest. \param bits  up to 30
constexpr std::int64_t cosine_word(std::uint64_t place, int address_bits, std::uint64_t power, int bits) {
  return rounded_word(unit_power(cosine_of_place(place, address_bits), power), bits);
}

/// What ROM 2 holds: 2/pi times the factor of the angle, for exponents 0..1000; exponent 0, what register 5 holds after a
/// reset, has 0.
/// \param Words  a container of 1001 std::int64_t, zero
template <class Words>
constexpr void fill_factors(Words& words, std::uint64_t q, std::uint64_t k, int bits) {
  const angle_factor factor(q, k);
  for (std::size_t n = 1; n < words.size(); ++n) words[n] = factor.word(n, bits);
}

/// What ROM 1 holds, k parts of 2^address_bits words: part 0 cos^k, which serves all n >= k, part m < k cos^m, which serves
/// n = m alone.
/// \param words  has room for them
template <class Words>
constexpr void fill_powers(Words& words, std::uint64_t k, int address_bits, int bits) {
  const std::size_t size = std::size_t(1) << address_bits;
  for (std::size_t part = 0; part < k; ++part) {
    for (std::size_t place = 0; place < size; ++place)
      words[part * size + place] = cosine_word(place, address_bits, part == 0 ? k : part, bits);
  }
}

}  // namespace blysk
