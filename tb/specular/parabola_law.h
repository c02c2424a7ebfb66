// SPDX-License-Identifier: Apache-2.0
/// The laws between registers and outputs of rtl_sysc/devices/parabola.h, composed in the netlist's order.
///
/// One composition serves two readers: kernels of a named format, whose widths are constants and whose integers are as
/// narrow as their nets, and the explorer's, whose widths are numbers of the moment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "rtl_sysc/devices/parabola.h"
#include "tb/specular/point_columns.h"
#include "tb/specular/rounding.h"

namespace blysk::specular {

/// The word lengths of a named format.
/// \tparam Formats  a parabola_formats
template <class Formats>
struct fixed_shape {
  static constexpr int cos_bits = Formats::cos_bits;
  static constexpr int coefficient_bits = Formats::coefficient_bits;
  static constexpr int diff_bits = Formats::diff_bits;
  static constexpr bool is_clamped = Formats::lobe == negative_lobe::clamped;
  static constexpr rounding how = rounding::nearest;

  using a_t = machine_int<typename Formats::a>;
  using cos_t = machine_int<typename Formats::cos_inv>;
  using square_t = machine_int<typename Formats::mul7::exact>;
  using product_t = machine_int<typename Formats::a_diff>;
  using rounded_t = machine_int<sq<9, Formats::cos_bits>>;
  using brdf_t = machine_int<typename Formats::brdf>;
  using out_t = std::conditional_t<(Formats::out::width <= 32), std::uint32_t, std::int64_t>;

  static constexpr bool has_headroom = Formats::a_diff::width < 8 * int{sizeof(product_t)};
};

/// Word lengths that are chosen at run time, everything in 64 bits.
struct free_shape {
  int cos_bits;
  int coefficient_bits;
  int diff_bits;
  bool is_clamped;
  bool has_headroom;  // half a unit of the result can be added to adder 11's sum
  rounding how = rounding::nearest;

  using a_t = std::int64_t;
  using cos_t = std::int64_t;
  using square_t = std::int64_t;
  using product_t = std::int64_t;
  using rounded_t = std::int64_t;
  using brdf_t = std::int64_t;
  using out_t = std::int64_t;
};

/// The same with headroom and rounding known to the compiler, so that the loop has no branch.
template <bool HasHeadroom, rounding How>
struct free_shape_with : free_shape {
  static constexpr bool has_headroom = HasHeadroom;
  static constexpr rounding how = How;
};

/// Calls `use` with the free_shape_with that the shape asks for.
template <class Use>
[[gnu::always_inline]] inline void with_known(const free_shape& shape, Use use) {
  const auto rounded = [&]<rounding How>() __attribute__((always_inline)) {
    if (shape.has_headroom) {
      use(free_shape_with<true, How>{shape});
    } else {
      use(free_shape_with<false, How>{shape});
    }
  };
  switch (shape.how) {
    case rounding::nearest:
      return rounded.template operator()<rounding::nearest>();
    case rounding::even:
      return rounded.template operator()<rounding::even>();
    case rounding::truncate:
      return rounded.template operator()<rounding::truncate>();
    case rounding::jam:
      return rounded.template operator()<rounding::jam>();
  }
}

/// From registers 1 and 2 to the BRDF, [P] fig. 1.
/// \param a  coefficient, raw, with coefficient_bits
/// \param c  cos(delta), raw, with cos_bits, 0..2^cos_bits; beyond, the result is unspecified
/// \return   BRDF, raw, with cos_bits
template <class Shape>
[[gnu::always_inline]] inline typename Shape::brdf_t parabola(const Shape& shape, typename Shape::a_t a,
                                                              typename Shape::cos_t c) {
  using cos_t = typename Shape::cos_t;
  using square_t = typename Shape::square_t;
  using product_t = typename Shape::product_t;
  constexpr cos_t carry28 = 1;
  constexpr product_t carry30 = 0;
  const auto cos2 = static_cast<cos_t>(
      drop_bits<Shape::how>(law::mul<square_t>(c, c, 0), 2 * shape.cos_bits - shape.diff_bits));
  const auto cos_inv = law::ones_complement<cos_t>(c, shape.diff_bits - shape.cos_bits);
  const auto diff = law::add<cos_t>(cos2, 0, cos_inv, 0, carry28);
  const auto a_diff = law::mul<product_t>(a, diff, 0);
  const int dropped = shape.coefficient_bits + shape.diff_bits - shape.cos_bits;
  const auto sum = law::add<product_t>(a_diff, 0, c, dropped, carry30);
  using rounded_t = typename Shape::rounded_t;
  const auto rounded = static_cast<rounded_t>(drop_bits<Shape::how>(sum, dropped, shape.has_headroom));
  const rounded_t low = shape.is_clamped ? 0 : std::numeric_limits<rounded_t>::min();
  const rounded_t high = shape.is_clamped ? static_cast<rounded_t>(rounded_t{1} << shape.cos_bits)
                                          : std::numeric_limits<rounded_t>::max();
  return static_cast<typename Shape::brdf_t>(law::clamp(rounded, low, high));
}

/// From the registers to 25, 26, 27 for every write.
/// \param coefficient  a of n, raw: what the device puts in front of multiplier 10
template <class Shape, class Coefficient, class Columns>
[[gnu::always_inline]] inline void shade(const Shape& shape, Coefficient coefficient, const Columns& io) {
  shade_points<typename Shape::out_t>(
      [&](std::uint16_t n, auto cos_delta) __attribute__((always_inline)) {
        return parabola(shape, coefficient(n), static_cast<typename Shape::cos_t>(cos_delta));
      },
      io);
}

}  // namespace blysk::specular
