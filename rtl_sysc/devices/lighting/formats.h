// SPDX-License-Identifier: Apache-2.0
/// The formats of the nets of the lighting unit. Intensities are in units of 1/255 of full light, as on the colour ports of
/// the specular devices.
#pragma once

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/mul.h"
#include "rtl_sysc/blocks/multiplexer.h"
#include "rtl_sysc/blocks/quantise.h"
#include "rtl_sysc/blocks/reg_level.h"
#include "rtl_sysc/blocks/rescale.h"
#include "rtl_sysc/formats.h"

#include <type_traits>

namespace blysk {

/// A bit of the stimulus that is no number.
struct flag : uq<1, 0> {
  using raw_t = bool;
};

/// An intensity of 0..255, both ends included: wired as UQ8.f, codes above 255 2^f are not legal.
template <int Frac>
struct intensity : uq<8, Frac> {
  static constexpr std::int64_t max = std::int64_t(255) << Frac;
};

/// An energy factor of 0..41: (n + 6)/24.55 of [T] (2.26) is 40.98 for n = 1000.
template <int Frac>
struct energy_factor : uq<6, Frac> {
  static constexpr std::int64_t max = std::int64_t(41) << Frac;
};

/// Nets of the lighting unit for Q::frac fraction bits of N.L and of the specular terms. Coefficients are UQ8.8, terms and
/// their sum have 16 fraction bits.
/// \tparam HasEnergy  a factor multiplies the specular terms
template <class Q, bool HasEnergy>
struct lighting_formats {
  static constexpr bool has_energy = HasEnergy;
  static constexpr int cos_bits = Q::frac;
  static constexpr int coefficient_bits = 8;
  static constexpr int sum_bits = 16;
  static constexpr int factor_bits = min_of(Q::frac + 2, 24);  // a product takes at most 62 bits

  using cos_theta = unit<cos_bits>;                 // N.L
  using coefficient = intensity<coefficient_bits>;  // I_a k_a, I_l k_d
  using specular_in = intensity<cos_bits>;          // outputs 25, 26, 27 of [P] fig. 1
  using factor = energy_factor<factor_bits>;
  using term = intensity<sum_bits>;   // ambient and diffuse
  using level = intensity<sum_bits>;  // the sum, saturated
  using highlight = std::conditional_t<HasEnergy, uq<14, sum_bits>, term>;
  using lit = uq<9, sum_bits>;
  using sum = std::conditional_t<HasEnergy, uq<14, sum_bits>, uq<10, sum_bits>>;

  using ambient = rescale<coefficient, term>;
  using diffuse = mul<coefficient, cos_theta, term>;
  using specular =
      std::conditional_t<HasEnergy, mul<specular_in, factor, highlight>, rescale<specular_in, highlight>>;
  using base = multiplexer<level, term, level>;
  using add_diffuse = add<level, term, lit>;
  using add_specular = add<lit, highlight, sum>;
  using saturate = quantise<sum, level, overflow::clamp>;
  using accumulator = reg_level<level>;
  using round = quantise<level, colour, overflow::excluded>;

  /// No net overflows for any legal input, whatever the number of lights: the accumulator is saturated after each.
  static constexpr bool no_overflow() {
    using std::int64_t;
    constexpr int64_t ambient_hi = ambient::law(int64_t(coefficient::max));
    constexpr int64_t diffuse_hi = diffuse::law(int64_t(coefficient::max), int64_t(cos_theta::max));
    constexpr int64_t highlight_hi = highest_highlight();
    constexpr int64_t lit_hi = add_diffuse::law(int64_t(level::max), diffuse_hi, int64_t(0));
    constexpr int64_t sum_hi = add_specular::law(lit_hi, highlight_hi, int64_t(0));
    constexpr int64_t level_hi = saturate::law(sum_hi);
    static_assert(fits<term>(0, ambient_hi) && fits<term>(0, diffuse_hi));
    static_assert(fits<highlight>(0, highlight_hi));
    static_assert(fits<lit>(0, lit_hi));
    static_assert(fits<sum>(0, sum_hi));
    static_assert(fits<level>(0, ambient_hi) && fits<level>(0, level_hi));
    static_assert(fits<colour>(0, round::law(level_hi)));
    return true;
  }

 private:
  static constexpr std::int64_t highest_highlight() {
    if constexpr (HasEnergy) {
      return specular::law(std::int64_t(specular_in::max), std::int64_t(factor::max));
    } else {
      return specular::law(std::int64_t(specular_in::max));
    }
  }
};

}  // namespace blysk
