// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/constant.h"
#include "rtl_sysc/blocks/divide.h"
#include "rtl_sysc/blocks/move_point.h"
#include "rtl_sysc/blocks/one_minus.h"
#include "rtl_sysc/blocks/quantise.h"
#include "rtl_sysc/devices/specular.h"

namespace blysk {

/// Nets of gx for Q::frac fraction bits F of cos(delta). The square is exact up to q12 and rounded to F + 12 bits beyond;
/// what follows is exact but the quotient, which has one bit more than the BRDF, so that it is rounded to nearest.
template <class Q>
struct gx_formats {
  static constexpr int cos_bits = Q::frac;
  static constexpr int square_bits = min_of(2 * cos_bits, cos_bits + 12);

  using n = exponent;
  using cos_delta = unit<cos_bits>;
  using square = unit<square_bits>;        // c^2
  using rest = unit<square_bits>;          // 1 - c^2
  using half_n = uq<9, 1>;                 // n/2
  using drop = uq<9, square_bits + 1>;     // n/2 (1 - c^2)
  using divisor = uq<9, square_bits + 1>;  // n/2 (1 - c^2) + c^2, at least 1/2
  using quotient = unit<cos_bits + 1>;
  using brdf = unit<cos_bits>;
  using out = uq<8, cos_bits>;

  using mul_cos = mul<cos_delta, cos_delta, square>;
  using sub_square = one_minus<square_bits>;
  using halve_n = move_point<n, half_n>;
  using mul_n = mul<half_n, rest, drop>;
  using add_divisor = add<drop, square, divisor>;
  using div = divide<square, divisor, quotient>;
  using quant = quantise<quotient, brdf, overflow::excluded>;
  using mul_colour = mul<brdf, colour, out>;

  /// No net overflows for any legal input: the laws themselves, taken at the ends of their operands. The divisor is a line
  /// in c^2, largest at c = 0 for the largest n. The quotient is largest at c = 1, where dividend and divisor are equal.
  static constexpr bool no_overflow() {
    using std::int64_t;
    constexpr int64_t square_hi = mul_cos::law(cos_delta::max, cos_delta::max);
    constexpr int64_t rest_hi = sub_square::law(int64_t(0));
    constexpr int64_t rest_lo = sub_square::law(square_hi);
    constexpr int64_t half_hi = halve_n::law(n::max);
    constexpr int64_t drop_hi = mul_n::law(half_hi, rest_hi);
    constexpr int64_t at_zero = add_divisor::law(drop_hi, int64_t(0), int64_t(0));
    constexpr int64_t at_peak = add_divisor::law(mul_n::law(half_hi, rest_lo), square_hi, int64_t(0));
    constexpr int64_t quotient_hi = div::law(square_hi, at_peak);
    static_assert(fits<square>(0, square_hi));
    static_assert(fits<rest>(rest_lo, rest_hi));
    static_assert(fits<half_n>(0, half_hi));
    static_assert(fits<drop>(0, drop_hi));
    static_assert(fits<divisor>(at_peak, at_zero));
    static_assert(fits<quotient>(0, quotient_hi));
    static_assert(fits<brdf>(0, quant::law(quotient_hi)));
    static_assert(fits<out>(0, mul_colour::law(brdf::max, colour::max)));
    return true;
  }
};

/// The quadratic over quadratic of the GameCube's GX lighting unit, in the place of the parabola of [P] fig. 1:
///   (r_o, g_o, b_o) = brdf * (R, G, B) k_s,   brdf = c^2 / (n/2 (1 - c^2) + c^2)
/// Ports, timing and reset are those of Base.
/// \tparam Formats  a gx_formats
/// \tparam Base     specular_device or iterative_device
template <class Formats, class Base = specular_device<Formats>>
struct gx : Base {
  using base = Base;
  template <class Q>
  using net = typename base::template net<Q>;

  constant<carry> ground;
  typename Formats::mul_cos SC_NAMED(mul_cos);
  typename Formats::sub_square SC_NAMED(sub_square);
  typename Formats::halve_n SC_NAMED(halve_n);
  typename Formats::mul_n SC_NAMED(mul_n);
  typename Formats::add_divisor SC_NAMED(add_divisor);
  typename base::template divider<typename Formats::div> SC_NAMED(div);
  typename Formats::quant SC_NAMED(quant);

  net<carry> SC_NAMED(grounded);
  net<typename Formats::square> SC_NAMED(square);
  net<typename Formats::rest> SC_NAMED(rest);
  net<typename Formats::half_n> SC_NAMED(half_n);
  net<typename Formats::drop> SC_NAMED(drop);
  net<typename Formats::divisor> SC_NAMED(divisor);
  net<typename Formats::quotient> SC_NAMED(quotient);

  explicit gx(const sc_core::sc_module_name& name) : base(name), ground("ground", 0) {
    static_assert(Formats::no_overflow());
    // clang-format off
    ground.y_o(grounded);
    mul_cos.a_i(this->cos_delta);  mul_cos.b_i(this->cos_delta);                              mul_cos.p_o(square);
    sub_square.a_i(square);                                                                   sub_square.y_o(rest);
    halve_n.a_i(this->n);                                                                     halve_n.y_o(half_n);
    mul_n.a_i(half_n);             mul_n.b_i(rest);                                           mul_n.p_o(drop);
    add_divisor.a_i(drop);         add_divisor.b_i(square);  add_divisor.carry_i(grounded);   add_divisor.s_o(divisor);
    div.a_i(square);               div.b_i(divisor);                                          div.q_o(quotient);
    quant.a_i(quotient);                                                                      quant.y_o(this->brdf);
    // clang-format on
    this->pace(div);
  }

  /// The parts list, for readers of the structure.
  auto blocks() const {
    return std::tuple_cat(base::blocks(),
                          std::tie(ground, mul_cos, sub_square, halve_n, mul_n, add_divisor, div, quant));
  }
};

}  // namespace blysk
