// SPDX-License-Identifier: Apache-2.0
/// The words and the formats of the nets of the arc-cosine unit.
#pragma once

#include "rtl_sysc/blocks/line_table.h"
#include "rtl_sysc/blocks/mul.h"
#include "rtl_sysc/blocks/one_minus.h"
#include "rtl_sysc/blocks/reg_level.h"
#include "rtl_sysc/blocks/sequencer.h"
#include "rtl_sysc/blocks/square_root.h"
#include "rtl_sysc/devices/angle_arithmetic.h"
#include "rtl_sysc/formats.h"

#include <array>
#include <cstddef>

namespace blysk {

/// arccos(1 - v) / sqrt v = sqrt 2 asin(sqrt(v/2)) / sqrt(v/2), rounded to nearest: sqrt 2 at v = 0, pi/2 at v = 1.
/// \param place  v 2^segment_bits, up to 2^segment_bits   \param segment_bits  up to 57   \param bits  up to 40
constexpr std::int64_t arc_ratio_word(std::uint64_t place, int segment_bits, int bits) {
  const std::uint64_t half = (kUnity59 / 2 >> segment_bits) * place;
  return rounded_word(unit_product(kRootOfTwo59, arcsine_ratio(half)), bits);
}

/// The words at v = 0, 2^-SegmentBits, ..., 1 with `Bits` fraction bits.
template <int SegmentBits, int Bits>
struct arc_ratio_words {
  static constexpr int segment_bits = SegmentBits;
  using memory = std::array<std::int64_t, (std::size_t(1) << SegmentBits) + 1>;

  static constexpr memory make_values() {
    memory all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = arc_ratio_word(i, SegmentBits, Bits);
    return all;
  }
  static constexpr memory values = make_values();

  static constexpr memory make_slopes() {
    memory all{};
    for (std::size_t i = 0; i + 1 < all.size(); ++i) all[i] = values[i + 1] - values[i];
    return all;
  }
  static constexpr memory slopes = make_slopes();
};

/// Nets of the arc-cosine unit for Q::frac fraction bits of the cosine. The angle has two fraction bits more; the root has
/// five more, so that what it loses is at most 0.2 ulp of the angle.
template <class Q>
struct arccos_formats {
  static constexpr int cos_bits = Q::frac;
  static constexpr int angle_bits = Q::frac + 2;
  static constexpr int root_bits = Q::frac + 5;
  static constexpr int segment_bits = Q::frac / 2;

  using cos_delta = unit<cos_bits>;
  using versine = unit<cos_bits>;  // v = 1 - cos
  using root_of_versine = uq<1, root_bits>;
  using ratio = uq<1, root_bits>;  // arccos(1 - v) / sqrt v
  using angle = uq<1, angle_bits>;
  using contents = arc_ratio_words<segment_bits, root_bits>;

  using sub = one_minus<cos_bits>;
  using root = square_root_steps<cos_bits, root_bits>;
  using control = sequencer<root::steps>;
  using line = line_table<cos_bits, ratio, contents>;
  using mul_angle = mul<root_of_versine, ratio, angle>;

  /// No net overflows for any legal input. The ratio rises with v.
  static constexpr bool no_overflow() {
    using std::int64_t;
    constexpr int64_t root_hi = int64_t(1) << root_bits;
    constexpr int64_t ratio_lo = line::law(int64_t(0));
    constexpr int64_t ratio_hi = line::law(int64_t(versine::max));
    constexpr int64_t angle_hi = mul_angle::law(root_hi, ratio_hi);
    static_assert(sub::law(int64_t(cos_delta::max)) == 0);
    static_assert(fits<versine>(0, sub::law(int64_t(0))));
    static_assert(fits<root_of_versine>(0, root_hi));
    static_assert(fits<ratio>(ratio_lo, ratio_hi));
    static_assert(fits<angle>(0, angle_hi));
    // The remainder is at most twice the root; the widest sum is what is left with two bits more.
    static_assert(fits<typename root::remainder_number>(0, 2 * root_hi));
    return true;
  }
};

}  // namespace blysk
