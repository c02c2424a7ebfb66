// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/constant.h"
#include "rtl_sysc/devices/rational/formats.h"
#include "rtl_sysc/devices/specular.h"

namespace blysk {

/// Registers and quotient, which both ways to r and d share; what derives from it drives the nets fall (r) and rise (d) from
/// the net n.
template <class Formats, class Base>
struct rational_quotient : Base {
  using base = Base;
  template <class Q>
  using net = typename base::template net<Q>;

  constant<typename Formats::unity> node1;
  constant<carry> ground;
  typename Formats::sub_cos SC_NAMED(sub_cos);
  typename Formats::mul_fall SC_NAMED(mul_fall);
  typename Formats::inv_drop SC_NAMED(inv_drop);
  typename Formats::add_line SC_NAMED(add_line);
  typename Formats::quant_line SC_NAMED(quant_line);
  typename Formats::mul_rise SC_NAMED(mul_rise);
  typename Formats::add_sum SC_NAMED(add_sum);
  typename Formats::quant_sum SC_NAMED(quant_sum);
  typename base::template divider<typename Formats::div> SC_NAMED(div);
  typename Formats::quant SC_NAMED(quant);

  net<typename Formats::unity> SC_NAMED(unity);
  net<carry> SC_NAMED(grounded);
  net<typename Formats::versine> SC_NAMED(versine);
  net<typename Formats::fall> SC_NAMED(fall);
  net<typename Formats::rise> SC_NAMED(rise);
  net<typename Formats::drop> SC_NAMED(drop);
  net<typename Formats::drop_inverted> SC_NAMED(drop_inverted);
  net<typename Formats::line> SC_NAMED(line);
  net<typename Formats::dividend> SC_NAMED(dividend);
  net<typename Formats::climb> SC_NAMED(climb);
  net<typename Formats::sum> SC_NAMED(sum);
  net<typename Formats::divisor> SC_NAMED(divisor);
  net<typename Formats::quotient> SC_NAMED(quotient);

  explicit rational_quotient(const sc_core::sc_module_name& name)
      : base(name), node1("node1", 1), ground("ground", 0) {
    static_assert(Formats::no_overflow());
    // clang-format off
    node1.y_o(unity);          ground.y_o(grounded);
    sub_cos.a_i(this->cos_delta);                                                        sub_cos.y_o(versine);
    mul_fall.a_i(fall);        mul_fall.b_i(versine);                                    mul_fall.p_o(drop);
    inv_drop.a_i(drop);                                                                  inv_drop.y_o(drop_inverted);
    add_line.a_i(unity);       add_line.b_i(drop_inverted);  add_line.carry_i(unity);    add_line.s_o(line);
    quant_line.a_i(line);                                                                quant_line.y_o(dividend);
    mul_rise.a_i(rise);        mul_rise.b_i(versine);                                    mul_rise.p_o(climb);
    add_sum.a_i(unity);        add_sum.b_i(climb);           add_sum.carry_i(grounded);  add_sum.s_o(sum);
    quant_sum.a_i(sum);                                                                  quant_sum.y_o(divisor);
    div.a_i(dividend);         div.b_i(divisor);                                         div.q_o(quotient);
    quant.a_i(quotient);                                                                 quant.y_o(this->brdf);
    // clang-format on
    this->pace(div);
  }

  auto blocks() const {
    return std::tuple_cat(base::blocks(), std::tie(node1, ground, sub_cos, mul_fall, inv_drop, add_line,
                                                   quant_line, mul_rise, add_sum, quant_sum, div, quant));
  }
};

/// A rational lobe, in the place of the parabola of [P] fig. 1:
///   (r_o, g_o, b_o) = brdf * (R, G, B) k_s,   brdf = (1 - r u)/(1 + d u), 0 beyond its root u = 1/r,   u = 1 - c
/// As (c + p0)/(p1 c + p2): p0 = 1/r - 1, p1 = -d/r, p2 = (1 + d)/r.
/// Ports, timing and reset are those of Base.
/// \tparam Formats  a rational_formats
/// \tparam Base     specular_device or iterative_device
template <class Formats, class Base = specular_device<Formats>, rational_fit Fit = Formats::fit>
struct rational;

/// r and d from two memories, which register 1 addresses.
template <class Formats, class Base>
struct rational<Formats, Base, rational_fit::best> : rational_quotient<Formats, Base> {
  using base = rational_quotient<Formats, Base>;

  typename Formats::rom_fall rom_fall;
  typename Formats::rom_rise rom_rise;

  explicit rational(const sc_core::sc_module_name& name)
      : base(name), rom_fall("rom_fall", 0), rom_rise("rom_rise", 1) {
    rom_fall.a_i(this->n);
    rom_fall.y_o(this->fall);
    rom_rise.a_i(this->n);
    rom_rise.y_o(this->rise);
  }

  /// The parts list, for readers of the structure.
  auto blocks() const { return std::tuple_cat(base::blocks(), std::tie(rom_fall, rom_rise)); }
};

/// r = (n + 3)/4, d = n - 1.
template <class Formats, class Base>
struct rational<Formats, Base, rational_fit::line> : rational_quotient<Formats, Base> {
  using base = rational_quotient<Formats, Base>;

  constant<typename Formats::three> node3;
  constant<typename Formats::minus_one> node_ones;
  typename Formats::add_fall SC_NAMED(add_fall);
  typename Formats::quarter SC_NAMED(quarter);
  typename Formats::add_rise SC_NAMED(add_rise);

  typename base::template net<typename Formats::three> SC_NAMED(three);
  typename base::template net<typename Formats::minus_one> SC_NAMED(minus_one);
  typename base::template net<typename Formats::n_plus_3> SC_NAMED(n_plus_3);

  explicit rational(const sc_core::sc_module_name& name)
      : base(name), node3("node3", 3), node_ones("node_ones", -1) {
    // clang-format off
    node3.y_o(three);         node_ones.y_o(minus_one);
    add_fall.a_i(this->n);    add_fall.b_i(three);      add_fall.carry_i(this->grounded);  add_fall.s_o(n_plus_3);
    quarter.a_i(n_plus_3);                                                                 quarter.y_o(this->fall);
    add_rise.a_i(this->n);    add_rise.b_i(minus_one);  add_rise.carry_i(this->grounded);  add_rise.s_o(this->rise);
    // clang-format on
  }

  auto blocks() const {
    return std::tuple_cat(base::blocks(), std::tie(node3, node_ones, add_fall, quarter, add_rise));
  }
};

}  // namespace blysk
