// SPDX-License-Identifier: Apache-2.0
/// The formats of the nets of UA 71489.
#pragma once

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/down_counter.h"
#include "rtl_sysc/blocks/filled_rom.h"
#include "rtl_sysc/blocks/magnitude.h"
#include "rtl_sysc/blocks/mul.h"
#include "rtl_sysc/blocks/multiplexer.h"
#include "rtl_sysc/blocks/part_decoder.h"
#include "rtl_sysc/blocks/parted_rom.h"
#include "rtl_sysc/blocks/quantise.h"
#include "rtl_sysc/blocks/reg_level.h"
#include "rtl_sysc/devices/angle/contents.h"
#include "rtl_sysc/formats.h"

#include <type_traits>

namespace blysk {

/// Pixels of a scan line, 1..1023.
struct pixel_number : uq<10, 0> {
  static constexpr std::int64_t min = 1;
};

/// An angle of [0, pi/2], rad, wired as UQ1.f: codes above the last one below pi/2 are not legal.
template <int Frac>
struct quarter_turn : uq<1, Frac> {
  static_assert(Frac <= 59);
  static constexpr std::int64_t max = static_cast<std::int64_t>(kHalfPi59 >> (59 - Frac));
};

/// Nets of UA 71489 for Q::frac fraction bits of the reflectance. Angles are in rad up to multiplier 2, whose product is in
/// quarter turns: the words of ROM 2 are 2/pi times the factor of the angle, so that the lobe ends where the product is 1.
///
/// ROM 1 has min(F + 1, 10) address bits in each part. The product is rounded to them; its operands keep so many bits that
/// they move it by at most half as much as this rounding.
/// \tparam HasEnergy  a factor of 0.07 to 279 multiplies the lobe
template <class Q, bool HasEnergy = false>
struct angle_formats {
  static constexpr bool has_energy = HasEnergy;
  static constexpr int angle_bits =
      Q::frac + 10;  // 1023 steps add up the step's rounding to at most 2^-(F + 1) rad
  static constexpr int address_bits = min_of(Q::frac + 1, 10);
  static constexpr int limited_bits = address_bits + 6;
  static constexpr int factor_bits = address_bits + 4;
  static constexpr int energy_bits = address_bits + 6;  // the least factor keeps as many digits as the place
  static constexpr std::size_t most_words = std::size_t(kMostPowers) << address_bits;

  using n = exponent;
  using intensity = colour;
  using start = quarter_turn<angle_bits>;
  using step = sq<-3, angle_bits>;  // -1/8 to below 1/8 rad
  using count = pixel_number;
  using part = uq<4, 0>;
  using angle = sq<8, angle_bits>;      // register 4
  using distance = uq<8, angle_bits>;   // from the lobe's axis
  using limited = uq<1, limited_bits>;  // as much of it as multiplier 2 takes; a lobe ends at pi/2 or before
  using factor = uq<5, factor_bits>;    // ROM 2
  using turned = uq<6, limited_bits + factor_bits>;  // multiplier 2
  using place = unit<address_bits>;                  // the lower address of ROM 1; 1: beyond the lobe
  using lobe = unit<Q::frac>;                        // ROM 1
  using energy = uq<9, energy_bits>;                 // factor of the lobe
  using brdf = std::conditional_t<HasEnergy, uq<9, Q::frac>, lobe>;
  using out = std::conditional_t<HasEnergy, uq<17, Q::frac>, uq<8, Q::frac>>;  // multiplier 1

  using cnt = down_counter<count>;
  using dec = part_decoder<n, part>;
  using mux = multiplexer<angle, start, angle>;
  using add4 = add<angle, step, angle>;
  using mag4 = magnitude<angle, distance>;
  using limit4 = quantise<distance, limited, overflow::clamp>;
  using rom2 = filled_rom<n, factor, 1001>;
  using mul2 = mul<limited, factor, turned>;
  using quant2 = quantise<turned, place, overflow::clamp>;
  using rom1 = parted_rom<part, place, lobe, most_words>;
  using rom_energy = filled_rom<n, energy, 1001>;
  using mul_energy = mul<lobe, energy, brdf>;
  using mul1 = mul<brdf, intensity, out>;

  /// No net overflows for any legal input, Q and k. The factor is largest for the largest Q, k = 1 and n = 1000; it is never
  /// below 2/pi, so that what limit4 cuts off lies beyond the lobe.
  static constexpr bool no_overflow() {
    using std::int64_t;
    int64_t lo = start::min;
    int64_t hi = start::max;
    for (int64_t pixel = 0; pixel <= count::max; ++pixel) {
      lo = add4::law(lo, step::min, int64_t(0));
      hi = add4::law(hi, step::max, int64_t(0));
    }
    constexpr int64_t factor_lo = angle_factor(500000, 1).word(1, factor_bits);
    constexpr int64_t factor_hi = angle_factor(kMillion - 1, 1).word(1000, factor_bits);
    constexpr int64_t turned_hi = mul2::law(limited::max, factor_hi);
    static_assert(fits<factor>(factor_lo, factor_hi));
    static_assert(fits<turned>(0, turned_hi));
    static_assert(quant2::law(mul2::law(limited::max, factor_lo)) == place::max);
    static_assert(fits<lobe>(0, cosine_word(0, address_bits, 1, Q::frac)));
    if constexpr (HasEnergy) {
      // Of all Q and k, the narrowest lobe has the largest factor.
      constexpr int64_t energy_hi =
          angle_factor(kMillion - 1, 1).energy_word(angle_energy::exact, 1000, energy_bits);
      constexpr int64_t brdf_hi = mul_energy::law(lobe::max, energy_hi);
      static_assert(fits<energy>(0, energy_hi));
      static_assert(fitted_word(900000, 1, 1000, energy_bits) < energy_hi);
      static_assert(fits<brdf>(0, brdf_hi));
      static_assert(fits<out>(0, mul1::law(brdf_hi, intensity::max)));
    } else {
      static_assert(fits<out>(0, mul1::law(brdf::max, intensity::max)));
    }
    return fits<angle>(lo, hi) && fits<distance>(0, mag4::law(lo)) && fits<distance>(0, mag4::law(hi));
  }
};

}  // namespace blysk
