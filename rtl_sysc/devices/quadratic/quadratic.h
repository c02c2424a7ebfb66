// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/devices/quadratic/formats.h"

namespace blysk {

/// Specular device of [P] (patent UA 60553) fig. 1; numbers are those of the figure.
///   (r_o, g_o, b_o) = brdf * (R, G, B) k_s,   brdf = a (c^2 - c) + c,   a = slope n + offset
/// Ports, timing and reset are those of specular_device, the path from a to the outputs is that of parabola_device.
/// Formats  Formats: a quadratic_formats.
/// \tparam Base  of parabola_device
template <class Formats, class Base = specular_device<Formats>>
struct quadratic : parabola_device<Formats, Base> {
  using base = parabola_device<Formats, Base>;
  template <class Q>
  using net = typename base::template net<Q>;

  constant<typename Formats::slope> node31;
  constant<typename Formats::offset> node32;
  typename Formats::mul6 SC_NAMED(mul6);
  typename Formats::add15 SC_NAMED(add15);

  net<typename Formats::slope> SC_NAMED(slope);
  net<typename Formats::offset> SC_NAMED(offset);
  net<typename Formats::slope_n> SC_NAMED(slope_n);

  typename base::template staged<typename Formats::slope_n> slope_n_1{"pipe_slope_n", "slope_n_1", 0, 1};

  /// \param cuts  of a pipelined_device
  template <class... Cuts>
  quadratic(const sc_core::sc_module_name& name, const wired_constants& wired, const Cuts&... cuts)
      : base(name, cuts...), node31("node31", wired.slope), node32("node32", wired.offset) {
    static_assert(Formats::no_overflow());
    // clang-format off
    node31.y_o(slope);     node32.y_o(offset);
    mul6.a_i(this->n);     mul6.b_i(slope);                                        mul6.p_o(slope_n);
    add15.a_i(this->at(slope_n_1, slope_n));
                           add15.b_i(offset);    add15.carry_i(this->carry30_in);  add15.s_o(this->a);
    // clang-format on
  }

  /// The parts list, for readers of the structure.
  auto blocks() const {
    return std::tuple_cat(base::blocks(), std::tie(node31, node32, mul6, add15, slope_n_1.registers));
  }
};

}  // namespace blysk
