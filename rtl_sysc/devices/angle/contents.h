// SPDX-License-Identifier: Apache-2.0
/// The words of the read-only memories of UA 71489 with the function of [A], by integer arithmetic at elaboration.
#pragma once

#include "rtl_sysc/devices/angle_arithmetic.h"

#include <array>
#include <cstddef>

namespace blysk {

/// Largest k of [A] that the four outputs of the decoder leave room for.
inline constexpr int kMostPowers = 15;

/// What keeps the energy of the lobe: its factor, coef of [A].
enum class angle_energy {
  published,  ///< the fitted formulas, for n > k; for n <= k as `exact`
  exact,      ///< 1 / (2 pi integral of lobe(x) cos x sin x dx)
  safe  ///< 1 / (8 pi integral of lobe(x) sin x dx), which keeps the reflectance at or below 1 at every incidence
};

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
    const rom_wide scaled = factor(n) * kTwoByPi59;  // 117 fraction bits
    return static_cast<std::int64_t>((scaled + (rom_wide(1) << (116 - bits))) >> (117 - bits));
  }

  /// The factor of the lobe by an integral. With y = a x, a the factor of the angle, and M(b) the integral of
  /// cos^k(y) sin(b y) dy from 0 to pi/2: a / (pi M(2/a)), rounded to nearest, or a / (8 pi M(1/a)), rounded down. For n <= k
  /// the lobe is cos^n, and a is 1.
  /// \param n     1..1000
  /// \param bits  up to 40
  constexpr std::int64_t energy_word(angle_energy which, std::uint64_t n, int bits) const {
    const bool is_safe = which == angle_energy::safe;
    const rom_wide scale = factor(n);
    const std::uint64_t reciprocal = static_cast<std::uint64_t>((rom_wide(1) << 117) / scale);
    const std::uint64_t moment = lobe_moment(n < k_ ? n : k_, is_safe ? reciprocal : 2 * reciprocal);
    const rom_wide divisor = rom_wide(unit_product(2 * kHalfPi59, moment)) * (is_safe ? 8 : 1);
    const rom_wide doubled = (scale << (bits + 2)) / divisor;
    return static_cast<std::int64_t>((is_safe ? doubled : doubled + 1) >> 1);
  }

 private:
  /// With 58 fraction bits.
  constexpr rom_wide factor(std::uint64_t n) const {
    rom_wide value = rom_wide(1) << 58;
    if (n > k_) {
      const std::uint64_t t = log_ / n;
      const rom_wide square = ((rom_wide(n) * decay_) << 58) / (rom_wide(k_) * decay_ratio(t));
      const std::uint64_t root = square_root(square << 58);  // 58 fraction bits
      value = rom_wide(root) * arc_ / arcsine_ratio(level(t));
    }
    return value;
  }

  static constexpr std::uint64_t level(std::uint64_t t) { return unit_product(t, decay_ratio(t)) / 2; }

  std::uint64_t log_;  // -ln Q
  std::uint64_t k_;
  std::uint64_t decay_, arc_;  // g and h at n = k
};

/// cos^power(pi/2 place / 2^address_bits), rounded to nearest. \param bits  up to 30
constexpr std::int64_t cosine_word(std::uint64_t place, int address_bits, std::uint64_t power, int bits) {
  return rounded_word(unit_power(cosine_of_place(place, address_bits), power), bits);
}

/// True where the fitted formulas of [A] hold: Q in [0.1, 0.4] or [0.5, 0.9], k in 1..5.
constexpr bool is_fitted(std::uint64_t q, std::uint64_t k) {
  return ((q >= 100000 && q <= 400000) || (q >= 500000 && q <= 900000)) && k >= 1 && k <= 5;
}

/// The fitted coef of [A], rounded to nearest: 0.608 n (Q - 0.193)/(2 Q + 2 k) + 0.161 n + 0.284 for Q <= 0.4,
/// 0.743 Q (0.167 n - 0.0133 k n)/k + 0.167 n + 0.245 for Q >= 0.5.
/// \param q, k  is_fitted()   \param n  above k
constexpr std::int64_t fitted_word(std::uint64_t q, std::uint64_t k, std::uint64_t n, int bits) {
  std::uint64_t numerator = 0;
  std::uint64_t denominator = 0;
  if (q <= 400000) {
    const std::uint64_t sum = q + k * kMillion;  // 10^6 (Q + k)
    numerator = 2 * (161 * n + 284) * sum + 608 * n * q - 608 * n * 193000;
    denominator = 2000 * sum;
  } else {
    const std::uint64_t unit = 10000000000 * k;
    numerator = (167 * n + 245) * unit + 743 * q * n * (1670 - 133 * k);
    denominator = 1000 * unit;
  }
  return rounded_ratio(numerator, denominator, bits);
}

/// What ROM 2 holds: 2/pi times the factor of the angle, for exponents 0..1000; exponent 0, what register 5 holds after a
/// reset, has 0.
/// \param Words  a container of 1001 std::int64_t, zero
template <class Words>
constexpr void fill_factors(Words& words, std::uint64_t q, std::uint64_t k, int bits) {
  const angle_factor factor(q, k);
  for (std::size_t n = 1; n < words.size(); ++n) words[n] = factor.word(n, bits);
}

/// The factors of the lobe for exponents 0..1000; exponent 0 has 0.
/// \param words  a container of 1001 std::int64_t, zero
/// \param q, k   is_fitted(), if the factors are the published ones
template <class Words>
constexpr void fill_energy(Words& words, angle_energy which, std::uint64_t q, std::uint64_t k, int bits) {
  const angle_factor factor(q, k);
  for (std::size_t n = 1; n < words.size(); ++n) {
    const bool is_by_fit = which == angle_energy::published && n > k;
    words[n] = is_by_fit ? fitted_word(q, k, n, bits) : factor.energy_word(which, n, bits);
  }
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
