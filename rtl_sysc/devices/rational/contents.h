// SPDX-License-Identifier: Apache-2.0
/// The words of the read-only memories of rational, by integer arithmetic.
#pragma once

#include "rtl_sysc/devices/angle_arithmetic.h"

#include <array>
#include <cstddef>

namespace blysk {

using fit_table = std::array<std::uint64_t, 1001>;
inline constexpr int kFitBits = 51;  // fraction bits of what is computed once for all formats

/// 1 / (1 - (level / 10^6)^(1/n)), as n / (L (1 - e^-x)/x) with L = -ln(level / 10^6), x = L/n.
/// \param level  50698 or 425856, so that L < 3   \param n  1..1000
/// \return       with kFitBits fraction bits, below 2^11; error below 2^-46
constexpr std::uint64_t reciprocal_distance(std::uint64_t level, std::uint64_t n) {
  const std::uint64_t log = log_of_reciprocal(level);
  const std::uint64_t divisor = unit_product(log, decay_ratio(log / n));
  return static_cast<std::uint64_t>((rom_wide(n) << (59 + kFitBits)) / divisor);
}

/// The lobe (1 - r u)/(1 + d u), u = 1 - c, for each n: it meets c^n at the levels v0 = 0.425856 and v1 = 0.050698. With
/// g = 1/u at a level and s = r + d
///   s = (g0 - g1) / (v0/(1 - v0) - v1/(1 - v1)),   r = g0 - s v0/(1 - v0)
/// docs/numerics.md shows that no other lobe of the form is better for large n. Both rise with n; r(1) = 1, d(1) = 0.
/// \return  [0]: r, [1]: d, by n, with kFitBits fraction bits, error below 2^-44; n = 0, which is not legal, has 0
constexpr std::array<fit_table, 2> make_fit() {
  const std::uint64_t v0 = 425856;
  const std::uint64_t v1 = 50698;
  std::array<fit_table, 2> all{};
  for (std::size_t n = 1; n < all[0].size(); ++n) {
    const std::uint64_t g0 = reciprocal_distance(v0, n);
    const std::uint64_t g1 = reciprocal_distance(v1, n);
    const rom_wide s = rom_wide(g0 - g1) * ((kMillion - v0) * (kMillion - v1)) / ((v0 - v1) * kMillion);
    all[0][n] = g0 - static_cast<std::uint64_t>(s * v0 / (kMillion - v0));
    // At n = 1 both are 1, and their last places are an error.
    all[1][n] = n == 1 ? 0 : static_cast<std::uint64_t>(s) - all[0][n];
  }
  return all;
}

inline constexpr std::array<fit_table, 2> kFit = make_fit();

/// r and d with `Bits` fraction bits, rounded to nearest.
template <int Bits>
struct fit_words {
  using table = std::array<std::int64_t, 1001>;

  static constexpr std::array<table, 2> make() {
    std::array<table, 2> all{};
    for (std::size_t which = 0; which < 2; ++which) {
      for (std::size_t n = 0; n < all[which].size(); ++n) {
        const std::uint64_t half = std::uint64_t(1) << (kFitBits - Bits - 1);
        all[which][n] = static_cast<std::int64_t>((kFit[which][n] + half) >> (kFitBits - Bits));
      }
    }
    return all;
  }

  static constexpr std::array<table, 2> words = make();
};

}  // namespace blysk
