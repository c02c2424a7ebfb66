// SPDX-License-Identifier: Apache-2.0
#include "tb/devices/cosine_quadratic/kernel.h"

#include <limits>

#include "tb/vector_clones.h"

namespace blysk::cosine_quadratic_device {
namespace {

/// The word lengths of a named format, in integers as narrow as its nets.
template <class Formats>
struct fixed_shape {
  static constexpr int cos_bits = Formats::cos_bits;
  static constexpr int slope_bits = Formats::slope_bits;
  static constexpr int line_bits = Formats::line_bits;
  static constexpr int square_bits = Formats::square_bits;
  static constexpr int limit_bits = Formats::limit_bits;
  static constexpr int factor_bits = Formats::factor_bits;
  static constexpr int weight_bits = Formats::weight_bits;
  static constexpr bool is_limited = Formats::is_limited;
  static constexpr bool gates_by_limit = Formats::gate == root_gate::limit;
  static constexpr bool has_factor = Formats::has_factor;
  static constexpr specular::rounding how = specular::rounding::nearest;

  using product_t = specular::machine_int<typename Formats::line>;
  using rounded_t = specular::machine_int<sq<10, line_bits>>;
  using square_t = specular::machine_int<typename Formats::mul10::exact>;
  using scaled_t = std::conditional_t<has_factor, std::int64_t, square_t>;
  using out_t = std::conditional_t<(Formats::out::width <= 32), std::uint32_t, std::int64_t>;
};

/// Word lengths of the moment with the rounding known to the compiler, so that the loop has no branch.
template <specular::rounding How>
struct free_shape_with : free_shape {
  static constexpr specular::rounding how = How;
};

/// From registers 1 and 2 to the BRDF.
/// \param n  code of the register of n
/// \param c  cos(gamma), raw, with cos_bits, 0..2^cos_bits; beyond, the result is unspecified
/// \return   BRDF, raw, with cos_bits
template <class Shape>
[[gnu::always_inline]] inline typename Shape::scaled_t brdf(const Shape& shape, const memories& words,
                                                            std::uint16_t n, typename Shape::product_t c) {
  using product_t = typename Shape::product_t;
  using rounded_t = typename Shape::rounded_t;
  using square_t = typename Shape::square_t;
  using scaled_t = typename Shape::scaled_t;
  constexpr product_t all_ones = -1;
  constexpr product_t grounded = 0;
  constexpr product_t carry29 = 1;
  const std::size_t address = n & 1023u;
  const int line_frac = shape.slope_bits + shape.cos_bits;
  const auto cos_minus_1 = law::add<product_t>(c, 0, all_ones, shape.cos_bits - shape.weight_bits, grounded);
  const auto product = law::mul<product_t>(static_cast<product_t>(words.slope[address]), cos_minus_1, 0);
  const auto line =
      law::add<product_t>(product, 0, grounded, line_frac,
                          law::move_up<product_t>(carry29, shape.weight_bits == 0 ? line_frac : 0));
  // Half a unit fits beside it: |line| < 2^9 in a format of 10 integer bits.
  const auto nearest =
      static_cast<rounded_t>(specular::drop_bits<Shape::how>(line, line_frac - shape.line_bits));
  const auto unity = static_cast<rounded_t>(rounded_t{1} << shape.line_bits);
  const rounded_t low =
      shape.is_limited ? static_cast<rounded_t>(-unity) : std::numeric_limits<rounded_t>::min();
  const rounded_t high = shape.is_limited ? unity : std::numeric_limits<rounded_t>::max();
  const auto rounded = static_cast<square_t>(law::clamp(nearest, low, high));
  const auto square = specular::drop_bits<Shape::how>(law::mul<square_t>(rounded, rounded, 0),
                                                      2 * shape.line_bits - shape.square_bits);
  bool is_off = false;
  if (shape.gates_by_limit) {
    const int frac = shape.square_bits > shape.limit_bits ? shape.square_bits : shape.limit_bits;
    is_off = law::below<std::int64_t>(square, frac - shape.square_bits, words.limit[address],
                                      frac - shape.limit_bits) != 0;
  } else {
    is_off = law::is_negative<product_t>(line) != 0;
  }
  const auto lobe = static_cast<scaled_t>(law::gate<square_t>(square, static_cast<square_t>(is_off)));
  if (!shape.has_factor) return lobe;
  return specular::drop_bits<Shape::how>(
      law::mul<scaled_t>(lobe, static_cast<scaled_t>(words.factor[address]), 0),
      shape.square_bits + shape.factor_bits - shape.cos_bits);
}

template <class Shape, class Columns>
[[gnu::always_inline]] inline void shade(const Shape& shape, const memories& words, const Columns& io) {
  specular::shade_points<typename Shape::out_t>(
      [&](std::uint16_t n, auto cos_delta) __attribute__((always_inline)) {
        return brdf(shape, words, n, static_cast<typename Shape::product_t>(cos_delta));
      },
      io);
}

}  // namespace

// A template cannot have clones, so every format gets a plain function of its own.
#define BLYSK_KERNEL(Q, Kind)                                                                  \
  using Q##_##Kind##_formats = formats_in<Q>::Kind;                                            \
  using Q##_##Kind##_columns = specular::columns_of<Q##_##Kind##_formats>;                     \
  void Q##_##Kind(const memories& words, const Q##_##Kind##_columns& io);                      \
  BLYSK_VECTOR_CLONES void Q##_##Kind(const memories& words, const Q##_##Kind##_columns& io) { \
    shade(fixed_shape<Q##_##Kind##_formats>{}, words, io);                                     \
  }                                                                                            \
  template <>                                                                                  \
  void compute<Q##_##Kind##_formats>(const memories& words, const Q##_##Kind##_columns& io) {  \
    Q##_##Kind(words, io);                                                                     \
  }
#define BLYSK_NAMED_FORMAT(name) \
  BLYSK_KERNEL(name, lobe)       \
  BLYSK_KERNEL(name, energy)     \
  BLYSK_KERNEL(name, by_limit)   \
  BLYSK_KERNEL(name, of_lsb)     \
  BLYSK_KERNEL(name, published)
#include "tb/formats.def"
#undef BLYSK_NAMED_FORMAT
#undef BLYSK_KERNEL

BLYSK_VECTOR_CLONES void compute(const free_shape& shape, const memories& words,
                                 const specular::free_columns& io) {
  switch (shape.how) {
    case specular::rounding::nearest:
      return shade(free_shape_with<specular::rounding::nearest>{shape}, words, io);
    case specular::rounding::even:
      return shade(free_shape_with<specular::rounding::even>{shape}, words, io);
    case specular::rounding::truncate:
      return shade(free_shape_with<specular::rounding::truncate>{shape}, words, io);
    case specular::rounding::jam:
      return shade(free_shape_with<specular::rounding::jam>{shape}, words, io);
  }
}

}  // namespace blysk::cosine_quadratic_device
