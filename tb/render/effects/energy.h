// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <string_view>

#include "tb/render/effects/fixed.h"

namespace blysk::render {

/// What the specular terms of a light are multiplied by, so that a surface reflects no more energy than it receives.
enum class normalisation {
  none,    ///< 1
  thesis,  ///< (n + 6)/24.55   [T] (2.26), for the cosine-quadratic lobe
  blinn    ///< (n + 6)/(8 pi)  [T] fig. 2.16, for cos^n
};

struct named_normalisation {
  normalisation is;
  std::string_view name, formula;
};
inline constexpr std::array kNormalisations{
    named_normalisation{normalisation::none, "none", "1"},
    named_normalisation{normalisation::thesis, "thesis", "(n + 6)/24.55"},
    named_normalisation{normalisation::blinn, "blinn", "(n + 6)/(8 pi)"}};

/// \param n  1..1000
/// \return   0.27..40.98
constexpr double energy_factor(normalisation by, int n) {
  if (by == normalisation::thesis) return (n + 6) / 24.55;
  if (by == normalisation::blinn) return (n + 6) / (8 * std::numbers::pi);
  return 1;
}

/// The factor of an exponent as a term takes it.
struct energy_share {
  double real = 1;
  std::int64_t code = 0;  ///< UQ6.bits, to nearest
  int bits = 0;           ///< fraction bits; 0: there is no factor
};

/// \param fraction  bits of N.H and of the specular terms
inline energy_share energy_of(normalisation by, int n, int fraction) {
  if (by == normalisation::none) return {};
  const double factor = energy_factor(by, n);
  const int bits = std::min(fraction + 2, 24);  // a product takes at most 62 bits
  return {factor, std::llround(std::ldexp(factor, bits)), bits};
}

/// energy I_l k_s lobe(n, N.H).   [T] (2.26)
/// \param result  0..255, an integer with `fraction` bits
/// \return        16 fraction bits, to nearest
constexpr std::int64_t normalised_term(std::int64_t result, int fraction, const energy_share& by) {
  return law::mul(result, by.code, fraction + by.bits - kSumBits);
}

}  // namespace blysk::render
