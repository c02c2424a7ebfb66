// SPDX-License-Identifier: Apache-2.0
/// The formats of the nets of table.
#pragma once

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/field.h"
#include "rtl_sysc/blocks/move_point.h"
#include "rtl_sysc/blocks/mul.h"
#include "rtl_sysc/blocks/one_minus.h"
#include "rtl_sysc/blocks/quantise.h"
#include "rtl_sysc/blocks/rom.h"
#include "rtl_sysc/devices/table/contents.h"
#include "rtl_sysc/formats.h"

namespace blysk {

/// Nets of table for Q::frac fraction bits F of cos(delta). A line is off by up to 2^-13, so that word lengths grow with F
/// up to q16 only; docs/devices/table.md derives each.
template <class Q>
struct table_formats {
  static constexpr int cos_bits = Q::frac;
  static constexpr int table_bits = min_of(cos_bits, 16);
  static constexpr int word_bits = table_bits + 3;   // fraction bits of the memories' words
  static constexpr int place_bits = table_bits - 1;  // of the place in a segment
  static constexpr int segment_bits = 5;             // a segment is 2^-5 long
  static constexpr int log_bits = min_of(2 * cos_bits + 1, table_bits + 12);

  using n = exponent;
  using cos_delta = unit<cos_bits>;
  using unity = uq<1, 0>;
  using versine = unit<cos_bits>;                    // u = 1 - c
  using half_versine = uq<0, cos_bits + 1>;          // u/2
  using factor = uq<1, cos_bits + 1>;                // 1 + u/2, [1, 1.5]
  using log = uq<1, log_bits>;                       // u (1 + u/2), [0, 1.5]
  using power_log = uq<11, log_bits>;                // t = n u (1 + u/2)
  using limited = uq<3, segment_bits + place_bits>;  // t, less than 8
  using index = uq<3 + segment_bits, 0>;
  using place = uq<0, place_bits>;
  using begin = uq<1, word_bits>;
  using change = sq<-segment_bits, word_bits>;
  using product = sq<-segment_bits, word_bits + place_bits>;
  using line = unit<word_bits + place_bits>;
  using brdf = unit<cos_bits>;
  using out = uq<8, cos_bits>;

  using contents = decay_words<word_bits>;
  using sub_cos = one_minus<cos_bits>;
  using halve_versine = move_point<versine, half_versine>;
  using add_factor = add<unity, half_versine, factor>;
  using mul_log = mul<versine, factor, log>;
  using mul_n = mul<n, log, power_log>;
  using quant_log = quantise<power_log, limited, overflow::clamp>;
  using cut_index = field<limited, index, place_bits>;
  using cut_place = field<limited, place, 0>;
  using rom_begin = rom<index, begin, contents>;
  using rom_change = rom<index, change, contents>;
  using mul_place = mul<change, place, product>;
  using add_line = add<begin, product, line>;
  using quant = quantise<line, brdf, overflow::excluded>;
  using mul_colour = mul<brdf, colour, out>;

  /// Where segment i's line is at a place.
  static constexpr std::int64_t line_at(std::int64_t i, std::int64_t at) {
    return add_line::law(rom_begin::law(0, i), mul_place::law(rom_change::law(1, i), at), std::int64_t(0));
  }

  /// The largest change of a line, which is negative.
  static constexpr std::int64_t steepest() {
    std::int64_t found = 0;
    for (std::int64_t i = 0; i <= index::max; ++i) {
      const std::int64_t fall = rom_change::law(1, i);
      if (fall < found) found = fall;
    }
    return found;
  }

  /// No line rises, and none begins above the end of the one before: the BRDF never falls as the cosine rises.
  static constexpr bool falls() {
    bool all = true;
    for (std::int64_t i = 0; i <= index::max; ++i) {
      all = all && rom_change::law(1, i) <= 0 && rom_begin::law(0, i) >= 0;
      if (i > 0) all = all && line_at(i, 0) <= line_at(i - 1, place::max);
    }
    return all;
  }

  /// No net overflows for any legal input: the laws themselves, taken at the ends of their operands, which for the lines
  /// are the begin of the first and the end of the last.
  static constexpr bool no_overflow() {
    using std::int64_t;
    constexpr int64_t one = 1;
    constexpr int64_t versine_hi = sub_cos::law(int64_t(0));
    constexpr int64_t versine_lo = sub_cos::law(cos_delta::max);
    constexpr int64_t half_hi = halve_versine::law(versine_hi);
    constexpr int64_t factor_hi = add_factor::law(one, half_hi, int64_t(0));
    constexpr int64_t log_hi = mul_log::law(versine_hi, factor_hi);
    constexpr int64_t power_log_hi = mul_n::law(n::max, log_hi);
    static_assert(fits<versine>(versine_lo, versine_hi));
    static_assert(fits<half_versine>(0, half_hi));
    static_assert(fits<factor>(0, factor_hi));
    static_assert(fits<log>(0, log_hi));
    static_assert(fits<power_log>(0, power_log_hi));
    static_assert(fits<limited>(0, quant_log::law(power_log_hi)));
    static_assert(fits<index>(0, cut_index::law(limited::max)));
    static_assert(falls());
    static_assert(fits<begin>(rom_begin::law(0, index::max), rom_begin::law(0, int64_t(0))));
    static_assert(fits<change>(steepest(), 0));
    static_assert(fits<product>(mul_place::law(steepest(), place::max), 0));
    static_assert(fits<line>(line_at(index::max, place::max), line_at(0, 0)));
    static_assert(fits<brdf>(0, quant::law(line::max)));
    static_assert(quant::law(line_at(index::max, place::max)) == 0);  // what t of 8 and more gives
    static_assert(fits<out>(0, mul_colour::law(brdf::max, colour::max)));
    return true;
  }
};

}  // namespace blysk
