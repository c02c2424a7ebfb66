// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/constant.h"
#include "rtl_sysc/blocks/divide.h"
#include "rtl_sysc/blocks/inverter_bank.h"
#include "rtl_sysc/blocks/quantise.h"
#include "rtl_sysc/devices/specular.h"

namespace blysk {

/// Nets of schlick for Q::frac fraction bits of cos(delta). All are exact but the quotient, which has one bit more than the
/// BRDF, so that it is rounded to nearest.
template <class Q>
struct schlick_formats {
  static constexpr int cos_bits = Q::frac;

  using n = exponent;
  using cos_delta = unit<cos_bits>;
  using unity = uq<1, 0>;
  using inverted = sq<1, cos_bits>;
  using versine = unit<cos_bits>;    // 1 - c
  using drop = uq<10, cos_bits>;     // n (1 - c)
  using divisor = uq<10, cos_bits>;  // n (1 - c) + c, in [1, n]
  using quotient = unit<cos_bits + 1>;
  using brdf = unit<cos_bits>;
  using out = uq<8, cos_bits>;

  using inv_cos = inverter_bank<cos_delta, inverted>;
  using add_cos = add<unity, inverted, versine>;
  using mul_n = mul<n, versine, drop>;
  using add_divisor = add<drop, cos_delta, divisor>;
  using div = divide<cos_delta, divisor, quotient>;
  using quant = quantise<quotient, brdf, overflow::excluded>;
  using mul_colour = mul<brdf, colour, out>;

  /// No net overflows for any legal input: the laws themselves, taken at the ends of their operands. The divisor falls as
  /// the cosine rises, and reaches 1, the largest dividend.
  static constexpr bool no_overflow() {
    using std::int64_t;
    constexpr int64_t one = 1;
    constexpr int64_t versine_hi = add_cos::law(one, inv_cos::law(int64_t(0)), one);
    constexpr int64_t versine_lo = add_cos::law(one, inv_cos::law(cos_delta::max), one);
    constexpr int64_t drop_hi = mul_n::law(n::max, versine_hi);
    constexpr int64_t divisor_hi = add_divisor::law(drop_hi, int64_t(0), int64_t(0));
    constexpr int64_t divisor_lo =
        add_divisor::law(mul_n::law(n::max, versine_lo), cos_delta::max, int64_t(0));
    constexpr int64_t quotient_hi = div::law(cos_delta::max, divisor_lo);
    static_assert(fits<inverted>(inv_cos::law(cos_delta::max), inv_cos::law(int64_t(0))));
    static_assert(fits<versine>(versine_lo, versine_hi));
    static_assert(fits<drop>(0, drop_hi));
    static_assert(fits<divisor>(divisor_lo, divisor_hi));
    static_assert(fits<quotient>(0, quotient_hi));
    static_assert(fits<brdf>(0, quant::law(quotient_hi)));
    static_assert(fits<out>(0, mul_colour::law(brdf::max, colour::max)));
    return true;
  }
};

/// Schlick's lobe, in the place of the parabola of [P] fig. 1:
///   (r_o, g_o, b_o) = brdf * (R, G, B) k_s,   brdf = c / (n - n c + c)   [T] (1.5) (2.1)
/// Ports, timing and reset are those of Base.
/// \tparam Formats  a schlick_formats
/// \tparam Base     specular_device or iterative_device
template <class Formats, class Base = specular_device<Formats>>
struct schlick : Base {
  using base = Base;
  template <class Q>
  using net = typename base::template net<Q>;

  constant<typename Formats::unity> node1;
  constant<carry> ground;
  typename Formats::inv_cos SC_NAMED(inv_cos);
  typename Formats::add_cos SC_NAMED(add_cos);
  typename Formats::mul_n SC_NAMED(mul_n);
  typename Formats::add_divisor SC_NAMED(add_divisor);
  typename base::template divider<typename Formats::div> SC_NAMED(div);
  typename Formats::quant SC_NAMED(quant);

  net<typename Formats::unity> SC_NAMED(unity);
  net<carry> SC_NAMED(grounded);
  net<typename Formats::inverted> SC_NAMED(inverted);
  net<typename Formats::versine> SC_NAMED(versine);
  net<typename Formats::drop> SC_NAMED(drop);
  net<typename Formats::divisor> SC_NAMED(divisor);
  net<typename Formats::quotient> SC_NAMED(quotient);

  explicit schlick(const sc_core::sc_module_name& name) : base(name), node1("node1", 1), ground("ground", 0) {
    static_assert(Formats::no_overflow());
    // clang-format off
    node1.y_o(unity);               ground.y_o(grounded);
    inv_cos.a_i(this->cos_delta);                                                                inv_cos.y_o(inverted);
    add_cos.a_i(unity);             add_cos.b_i(inverted);            add_cos.carry_i(unity);         add_cos.s_o(versine);
    mul_n.a_i(this->n);             mul_n.b_i(versine);                                          mul_n.p_o(drop);
    add_divisor.a_i(drop);          add_divisor.b_i(this->cos_delta); add_divisor.carry_i(grounded);  add_divisor.s_o(divisor);
    div.a_i(this->cos_delta);       div.b_i(divisor);                                            div.q_o(quotient);
    quant.a_i(quotient);                                                                         quant.y_o(this->brdf);
    // clang-format on
    this->pace(div);
  }

  /// The parts list, for readers of the structure.
  auto blocks() const {
    return std::tuple_cat(base::blocks(),
                          std::tie(node1, ground, inv_cos, add_cos, mul_n, add_divisor, div, quant));
  }
};

}  // namespace blysk
