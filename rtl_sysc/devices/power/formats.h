// SPDX-License-Identifier: Apache-2.0
/// The formats of the nets of power.
#pragma once

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/either.h"
#include "rtl_sysc/blocks/field.h"
#include "rtl_sysc/blocks/inverter_bank.h"
#include "rtl_sysc/blocks/key.h"
#include "rtl_sysc/blocks/mul.h"
#include "rtl_sysc/blocks/normalise.h"
#include "rtl_sysc/blocks/quantise.h"
#include "rtl_sysc/blocks/rom.h"
#include "rtl_sysc/blocks/shift_right.h"
#include "rtl_sysc/devices/power/contents.h"
#include "rtl_sysc/formats.h"

namespace blysk {

/// Bits of an unsigned integer up to `largest`.
constexpr int bits_of(int largest) {
  return largest == 0 ? 0 : 1 + bits_of(largest / 2);
}

/// Lines that stand for a falling curve of [0, 1): two memories, a multiplier, an adder and a cut.
/// \tparam SegmentBits  logarithm of the number of lines
/// \tparam PlaceBits    bits that say where in a line's segment the argument lies
/// \tparam Fall         no line falls by 2^-Fall
/// \tparam WordBits     fraction bits of the words
/// \tparam ValueBits    of what is cut from the lines
/// \tparam Contents     the words: [0] begins, [1] changes
template <int SegmentBits, int PlaceBits, int Fall, int WordBits, int ValueBits, class Contents>
struct interpolation {
  static constexpr int segment_bits = SegmentBits;

  using index = uq<SegmentBits, 0>;
  using place = uq<0, PlaceBits>;
  using begin = uq<1, WordBits>;
  using change = sq<-Fall, WordBits>;
  using product = sq<-Fall, WordBits + PlaceBits>;
  using line = uq<1, WordBits + PlaceBits>;
  using value = uq<1, ValueBits>;

  using rom_begin = rom<index, begin, Contents>;
  using rom_change = rom<index, change, Contents>;
  using mul_place = mul<change, place, product>;
  using add_line = add<begin, product, line>;
  using cut_line = field<line, value, line::frac - value::frac>;

  static constexpr std::int64_t product_at(std::int64_t segment, std::int64_t at) {
    return mul_place::law(rom_change::law(1, segment), at);
  }
  static constexpr std::int64_t line_at(std::int64_t segment, std::int64_t at) {
    return add_line::law(rom_begin::law(0, segment), product_at(segment, at), std::int64_t(0));
  }
  static constexpr std::int64_t largest() { return cut_line::law(line_at(0, 0)); }

  /// No line overflows: the laws at the ends of each. None rises.
  static constexpr bool no_overflow() {
    static_assert(fits<begin>(smallest<item::begin>(), -smallest<item::begin, -1>()));
    static_assert(fits<change>(smallest<item::change>(), -smallest<item::change, -1>()));
    static_assert(smallest<item::change, -1>() >= 0);
    static_assert(fits<product>(smallest<item::product>(), -smallest<item::product, -1>()));
    static_assert(fits<line>(smallest<item::line>(), -smallest<item::line, -1>()));
    static_assert(fits<value>(0, largest()));
    return true;
  }

 private:
  enum class item { begin, change, product, line };

  template <item What>
  static constexpr std::int64_t item_at(std::int64_t segment, std::int64_t at) {
    if constexpr (What == item::begin) return rom_begin::law(0, segment);
    if constexpr (What == item::change) return rom_change::law(1, segment);
    if constexpr (What == item::product) return product_at(segment, at);
    if constexpr (What == item::line) return line_at(segment, at);
  }

  /// The smallest of what all segments have at their ends, times the sign.
  template <item What, int Sign = 1>
  static constexpr std::int64_t smallest() {
    std::int64_t found = Sign * item_at<What>(0, 0);
    for (std::int64_t i = 0; i <= index::max; ++i) {
      const std::int64_t first = Sign * item_at<What>(i, 0);
      const std::int64_t last = Sign * item_at<What>(i, place::max);
      if (first < found) found = first;
      if (last < found) found = last;
    }
    return found;
  }
};

/// Nets of power for Q::frac fraction bits F of cos(delta). The BRDF has F fraction bits again and is within 1 ulp of
/// cos^n; docs/devices/power.md derives each word length from that.
template <class Q>
struct power_formats {
  static constexpr int cos_bits = Q::frac;
  static constexpr int zero_bits = bits_of(cos_bits - 1);  // of the number of leading zeros
  static constexpr int fraction_bits = cos_bits - 1;       // of the normalised cosine
  static constexpr int ratio_segments = cos_bits / 2 - 2;  // logarithms of the numbers of lines
  static constexpr int power_segments = cos_bits / 2 - 1;
  static constexpr int word_bits = cos_bits + 4;   // fraction bits of the memories' words
  static constexpr int value_bits = cos_bits + 3;  // of what is cut from the lines
  static constexpr int log_bits = min_of(2 * cos_bits + 1, cos_bits + 12);
  static constexpr int place_bits = cos_bits + 3;           // of the fraction of -log2 of the result
  static constexpr int shift_bits = bits_of(cos_bits + 2);  // a shift by so many places leaves nothing

  using ratios = interpolation<ratio_segments, fraction_bits - ratio_segments, ratio_segments + 1, word_bits,
                               value_bits, log_ratio_words<ratio_segments, word_bits, value_bits>>;
  using powers = interpolation<power_segments, place_bits - power_segments, power_segments, word_bits,
                               value_bits, power_words<power_segments, word_bits, value_bits, place_bits>>;

  using n = exponent;
  using cos_delta = unit<cos_bits>;
  using zeros = uq<zero_bits, 0>;
  using normalised = uq<2, fraction_bits>;  // 1 + f, [1, 2]
  using two = uq<2, 0>;
  using inverted = sq<2, fraction_bits>;
  using distance = unit<fraction_bits>;  // 1 - f
  using ratio = typename ratios::value;  // (1 - log2(1 + f))/(1 - f)
  using log_product = uq<2, fraction_bits + value_bits>;
  using log_fraction = uq<1, log_bits>;              // 1 - log2(1 + f)
  using log = uq<zero_bits, log_bits>;               // -log2 c
  using power_log = uq<10 + zero_bits, log_bits>;    // -n log2 c
  using places = uq<shift_bits, 0>;                  // its integer, up to where nothing is left,
  using above = uq<10 + zero_bits - shift_bits, 0>;  // and beyond
  using power = typename powers::value;              // 2^-x, 0 <= x < 1
  using brdf = unit<cos_bits>;
  using out = uq<8, cos_bits>;

  using norm = normalise<cos_bits, zeros>;
  using inv_f = inverter_bank<normalised, inverted>;
  using add_f = add<two, inverted, distance>;
  using index_ratio = field<normalised, typename ratios::index, fraction_bits - ratio_segments>;
  using place_ratio = field<normalised, typename ratios::place, 0>;
  using mul_log = mul<distance, ratio, log_product>;
  using cut_log = field<log_product, log_fraction, log_product::frac - log_fraction::frac>;
  using add_log = add<zeros, log_fraction, log>;
  using mul_n = mul<n, log, power_log>;
  using cut_above = field<power_log, above, log_bits + shift_bits>;
  using cut_places = field<power_log, places, log_bits>;
  using index_power = field<power_log, typename powers::index, log_bits - power_segments>;
  using place_power = field<power_log, typename powers::place, log_bits - place_bits>;
  using shift = shift_right<power, places>;
  using quant = quantise<power, brdf, overflow::excluded>;
  using off = either<above>;
  using key_brdf = key<brdf>;
  using mul_colour = mul<brdf, colour, out>;

  /// No net overflows for any legal input: the laws themselves, taken at the ends of their operands.
  static constexpr bool no_overflow() {
    using std::int64_t;
    constexpr int64_t one = int64_t(1) << fraction_bits;
    constexpr int64_t distance_hi = add_f::law(int64_t(2), inv_f::law(one), int64_t(1));
    constexpr int64_t distance_lo = add_f::law(int64_t(2), inv_f::law(2 * one), int64_t(1));
    constexpr int64_t log_product_hi = mul_log::law(distance_hi, ratios::largest());
    constexpr int64_t log_fraction_hi = cut_log::law(log_product_hi);
    constexpr int64_t log_hi = add_log::law(zeros::max, log_fraction_hi, int64_t(0));
    constexpr int64_t nothing = cos_bits + 2;
    static_assert(ratios::no_overflow() && powers::no_overflow());
    static_assert(fits<normalised>(one, 2 * one));
    static_assert(fits<inverted>(inv_f::law(2 * one), inv_f::law(one)));
    static_assert(fits<distance>(distance_lo, distance_hi));
    static_assert(fits<log_product>(0, log_product_hi));
    static_assert(fits<log_fraction>(0, log_fraction_hi));
    static_assert(fits<log>(0, log_hi));
    static_assert(fits<power_log>(0, mul_n::law(n::max, log_hi)));
    static_assert(fits<places>(0, nothing));
    static_assert(quant::law(shift::law(powers::largest(), nothing)) ==
                  0);  // so the key may close beyond `places`
    static_assert(fits<brdf>(0, quant::law(powers::largest())));
    static_assert(fits<out>(0, mul_colour::law(brdf::max, colour::max)));
    return true;
  }
};

}  // namespace blysk
