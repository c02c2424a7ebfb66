// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/constant.h"
#include "rtl_sysc/blocks/inverter_bank.h"
#include "rtl_sysc/blocks/quantise.h"
#include "rtl_sysc/devices/specular.h"

namespace blysk {

/// Nets of the linear device for Q::frac fraction bits of cos(delta).
template <class Q>
struct linear_formats {
  static constexpr int cos_bits = Q::frac;

  using n = exponent;
  using cos_delta = unit<cos_bits>;
  using one = uq<1, 0>;
  using inverted = sq<1, cos_bits>;  // -c - 1 ulp, and -n (1 - c) - 1 ulp below
  using versine = unit<cos_bits>;    // 1 - c
  using drop = uq<10, cos_bits>;     // n (1 - c)
  using drop_inverted = sq<10, cos_bits>;
  using line = sq<10, cos_bits>;  // 1 - n (1 - c)
  using brdf = unit<cos_bits>;
  using out = uq<8, cos_bits>;

  using inv1 = inverter_bank<cos_delta, inverted>;
  using add1 = add<one, inverted, versine>;
  using mul2 = mul<n, versine, drop>;
  using inv2 = inverter_bank<drop, drop_inverted>;
  using add2 = add<one, drop_inverted, line>;
  using quant2 = quantise<line, brdf, overflow::clamp>;

  /// No net overflows for any legal input.
  static constexpr bool no_overflow() {
    using std::int64_t;
    constexpr int64_t drop_hi = mul2::law(n::max, versine::max);
    constexpr int64_t line_lo = add2::law(int64_t(1), inv2::law(drop_hi), int64_t(1));
    static_assert(fits<drop>(0, drop_hi));
    static_assert(fits<drop_inverted>(inv2::law(drop_hi), inv2::law(int64_t(0))));
    static_assert(fits<line>(line_lo, versine::max));
    return true;
  }
};

/// A toy: brdf = max(0, 1 - n (1 - c)), what "A new device" (docs/new-device.md) is tried on.
template <class Formats>
struct linear : specular_device<Formats> {
  using base = specular_device<Formats>;
  template <class Q>
  using net = typename base::template net<Q>;

  constant<typename Formats::one> node1;
  typename Formats::inv1 SC_NAMED(inv1);
  typename Formats::add1 SC_NAMED(add1);
  typename Formats::mul2 SC_NAMED(mul2);
  typename Formats::inv2 SC_NAMED(inv2);
  typename Formats::add2 SC_NAMED(add2);
  typename Formats::quant2 SC_NAMED(quant2);

  net<typename Formats::one> SC_NAMED(one);
  net<typename Formats::inverted> SC_NAMED(cos_inv);
  net<typename Formats::versine> SC_NAMED(versine);
  net<typename Formats::drop> SC_NAMED(drop);
  net<typename Formats::drop_inverted> SC_NAMED(drop_inv);
  net<typename Formats::line> SC_NAMED(line);

  explicit linear(const sc_core::sc_module_name& name) : base(name), node1("node1", 1) {
    static_assert(Formats::no_overflow());
    // clang-format off
    node1.y_o(one);
    inv1.a_i(this->cos_delta);                                              inv1.y_o(cos_inv);
    add1.a_i(one);           add1.b_i(cos_inv);       add1.carry_i(one);    add1.s_o(versine);
    mul2.a_i(this->n);       mul2.b_i(versine);                             mul2.p_o(drop);
    inv2.a_i(drop);                                                         inv2.y_o(drop_inv);
    add2.a_i(one);           add2.b_i(drop_inv);      add2.carry_i(one);    add2.s_o(line);
    quant2.a_i(line);                                                       quant2.y_o(this->brdf);
    // clang-format on
  }

  /// The parts list, for readers of the structure.
  auto blocks() const {
    return std::tuple_cat(base::blocks(), std::tie(node1, inv1, add1, mul2, inv2, add2, quant2));
  }
};

}  // namespace blysk
