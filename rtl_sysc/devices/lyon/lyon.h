// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/constant.h"
#include "rtl_sysc/blocks/inverter_bank.h"
#include "rtl_sysc/blocks/move_point.h"
#include "rtl_sysc/blocks/quantise.h"
#include "rtl_sysc/devices/specular.h"

namespace blysk {

/// Nets of lyon for Q::frac fraction bits of cos(delta). The line 1 - n (1 - c)/2^Squarings is exact; each square but the
/// last keeps three fraction bits more than the BRDF.
/// \tparam Squarings  1, 2, 3: the degree is 2, 4, 8
template <class Q, int Squarings>
struct lyon_formats {
  static_assert(1 <= Squarings && Squarings <= 3);
  static constexpr int squarings = Squarings;
  static constexpr int cos_bits = Q::frac;
  static constexpr int line_bits = Q::frac + Squarings;
  static constexpr int guard_bits = 3;

  using n = exponent;
  using cos_delta = unit<cos_bits>;
  using unity = uq<1, 0>;
  using inverted = sq<1, cos_bits>;
  using versine = unit<cos_bits>;              // 1 - c
  using part = uq<10 - Squarings, Squarings>;  // n / 2^Squarings: the wires of n
  using drop = uq<10 - Squarings, line_bits>;  // n (1 - c) / 2^Squarings
  using drop_inverted = sq<10 - Squarings, line_bits>;
  using line = sq<10 - Squarings, line_bits>;
  using root = unit<line_bits>;               // the line, 0 where it is negative
  using power = unit<cos_bits + guard_bits>;  // squares but the last
  using brdf = unit<cos_bits>;
  using out = uq<8, cos_bits>;

  using inv_cos = inverter_bank<cos_delta, inverted>;
  using add_cos = add<unity, inverted, versine>;
  using part_n = move_point<n, part>;
  using mul_n = mul<part, versine, drop>;
  using inv_drop = inverter_bank<drop, drop_inverted>;
  using add_line = add<unity, drop_inverted, line>;
  using quant_line = quantise<line, root, overflow::clamp>;
  using first_square = mul<root, root, std::conditional_t<Squarings == 1, brdf, power>>;
  using next_square = mul<power, power, power>;
  using last_square = mul<power, power, brdf>;
  using mul_colour = mul<brdf, colour, out>;

  /// No net overflows for any legal input: the laws themselves, taken at the ends of their operands.
  static constexpr bool no_overflow() {
    using std::int64_t;
    constexpr int64_t one = 1;
    constexpr int64_t versine_hi = add_cos::law(one, inv_cos::law(int64_t(0)), one);
    constexpr int64_t versine_lo = add_cos::law(one, inv_cos::law(cos_delta::max), one);
    constexpr int64_t drop_hi = mul_n::law(part_n::law(n::max), versine_hi);
    constexpr int64_t line_lo = add_line::law(one, inv_drop::law(drop_hi), one);
    constexpr int64_t line_hi = add_line::law(one, inv_drop::law(int64_t(0)), one);
    static_assert(fits<inverted>(inv_cos::law(cos_delta::max), inv_cos::law(int64_t(0))));
    static_assert(fits<versine>(versine_lo, versine_hi));
    static_assert(fits<drop>(0, drop_hi));
    static_assert(fits<drop_inverted>(inv_drop::law(drop_hi), inv_drop::law(int64_t(0))));
    static_assert(fits<line>(line_lo, line_hi));
    static_assert(fits<root>(quant_line::law(line_lo), quant_line::law(line_hi)));
    static_assert(fits<power>(0, mul<root, root, power>::law(root::max, root::max)));
    static_assert(fits<power>(0, next_square::law(power::max, power::max)));
    static_assert(fits<brdf>(0, last_square::law(power::max, power::max)));
    static_assert(fits<brdf>(0, mul<root, root, brdf>::law(root::max, root::max)));
    static_assert(fits<out>(0, mul_colour::law(brdf::max, colour::max)));
    return true;
  }
};

/// Registers, line and its limit, which all degrees of lyon share; what derives from it drives the net brdf from the net
/// root.
template <class Formats>
struct lyon_line : specular_device<Formats> {
  using base = specular_device<Formats>;
  template <class Q>
  using net = typename base::template net<Q>;

  constant<typename Formats::unity> node1;
  typename Formats::inv_cos SC_NAMED(inv_cos);
  typename Formats::add_cos SC_NAMED(add_cos);
  typename Formats::part_n SC_NAMED(part_n);
  typename Formats::mul_n SC_NAMED(mul_n);
  typename Formats::inv_drop SC_NAMED(inv_drop);
  typename Formats::add_line SC_NAMED(add_line);
  typename Formats::quant_line SC_NAMED(quant_line);

  net<typename Formats::unity> SC_NAMED(unity);
  net<typename Formats::inverted> SC_NAMED(inverted);
  net<typename Formats::versine> SC_NAMED(versine);
  net<typename Formats::part> SC_NAMED(part);
  net<typename Formats::drop> SC_NAMED(drop);
  net<typename Formats::drop_inverted> SC_NAMED(drop_inverted);
  net<typename Formats::line> SC_NAMED(line);
  net<typename Formats::root> SC_NAMED(root);

  explicit lyon_line(const sc_core::sc_module_name& name) : base(name), node1("node1", 1) {
    static_assert(Formats::no_overflow());
    // clang-format off
    node1.y_o(unity);
    inv_cos.a_i(this->cos_delta);                                                      inv_cos.y_o(inverted);
    add_cos.a_i(unity);       add_cos.b_i(inverted);        add_cos.carry_i(unity);    add_cos.s_o(versine);
    part_n.a_i(this->n);                                                               part_n.y_o(part);
    mul_n.a_i(part);          mul_n.b_i(versine);                                      mul_n.p_o(drop);
    inv_drop.a_i(drop);                                                                inv_drop.y_o(drop_inverted);
    add_line.a_i(unity);      add_line.b_i(drop_inverted);  add_line.carry_i(unity);   add_line.s_o(line);
    quant_line.a_i(line);                                                              quant_line.y_o(root);
    // clang-format on
  }

  auto blocks() const {
    return std::tuple_cat(base::blocks(),
                          std::tie(node1, inv_cos, add_cos, part_n, mul_n, inv_drop, add_line, quant_line));
  }
};

/// Lyon's lobe for hardware, in the place of the parabola of [P] fig. 1:
///   (r_o, g_o, b_o) = brdf * (R, G, B) k_s,   brdf = (1 - n (1 - c)/K)^K, 0 beyond its root c = 1 - K/n,   K = 2, 4, 8
/// R. Lyon, Phong Shading Reformulation for Hardware Renderer Simplification, Apple TR 43, 1993.
/// Ports, timing and reset are those of specular_device.
/// \tparam Formats  a lyon_formats
template <class Formats, int Squarings = Formats::squarings>
struct lyon;

template <class Formats>
struct lyon<Formats, 1> : lyon_line<Formats> {
  using base = lyon_line<Formats>;

  typename Formats::first_square SC_NAMED(square2);

  explicit lyon(const sc_core::sc_module_name& name) : base(name) {
    square2.a_i(this->root);
    square2.b_i(this->root);
    square2.p_o(this->brdf);
  }

  auto blocks() const { return std::tuple_cat(base::blocks(), std::tie(square2)); }
};

template <class Formats>
struct lyon<Formats, 2> : lyon_line<Formats> {
  using base = lyon_line<Formats>;

  typename Formats::first_square SC_NAMED(square2);
  typename Formats::last_square SC_NAMED(square4);

  typename base::template net<typename Formats::power> SC_NAMED(power2);

  explicit lyon(const sc_core::sc_module_name& name) : base(name) {
    // clang-format off
    square2.a_i(this->root);  square2.b_i(this->root);  square2.p_o(power2);
    square4.a_i(power2);      square4.b_i(power2);      square4.p_o(this->brdf);
    // clang-format on
  }

  auto blocks() const { return std::tuple_cat(base::blocks(), std::tie(square2, square4)); }
};

template <class Formats>
struct lyon<Formats, 3> : lyon_line<Formats> {
  using base = lyon_line<Formats>;

  typename Formats::first_square SC_NAMED(square2);
  typename Formats::next_square SC_NAMED(square4);
  typename Formats::last_square SC_NAMED(square8);

  typename base::template net<typename Formats::power> SC_NAMED(power2);
  typename base::template net<typename Formats::power> SC_NAMED(power4);

  explicit lyon(const sc_core::sc_module_name& name) : base(name) {
    // clang-format off
    square2.a_i(this->root);  square2.b_i(this->root);  square2.p_o(power2);
    square4.a_i(power2);      square4.b_i(power2);      square4.p_o(power4);
    square8.a_i(power4);      square8.b_i(power4);      square8.p_o(this->brdf);
    // clang-format on
  }

  auto blocks() const { return std::tuple_cat(base::blocks(), std::tie(square2, square4, square8)); }
};

}  // namespace blysk
