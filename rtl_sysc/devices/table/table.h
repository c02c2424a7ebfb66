// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/constant.h"
#include "rtl_sysc/devices/specular.h"
#include "rtl_sysc/devices/table/formats.h"

namespace blysk {

/// A memory of 256 lines, in the place of the parabola of [P] fig. 1:
///   (r_o, g_o, b_o) = brdf * (R, G, B) k_s,   brdf = e^-t, 0 from t = 8 on,   t = n u (1 + u/2),   u = 1 - c
/// u + u^2/2 are the first terms of -ln(1 - u), so that one memory of e^-t serves every n.
/// Ports, timing and reset are those of specular_device.
/// \tparam Formats  a table_formats
template <class Formats>
struct table : specular_device<Formats> {
  using base = specular_device<Formats>;
  template <class Q>
  using net = typename base::template net<Q>;

  constant<typename Formats::unity> node1;
  constant<carry> ground;
  typename Formats::sub_cos SC_NAMED(sub_cos);
  typename Formats::halve_versine SC_NAMED(halve_versine);
  typename Formats::add_factor SC_NAMED(add_factor);
  typename Formats::mul_log SC_NAMED(mul_log);
  typename Formats::mul_n SC_NAMED(mul_n);
  typename Formats::quant_log SC_NAMED(quant_log);
  typename Formats::cut_index SC_NAMED(cut_index);
  typename Formats::cut_place SC_NAMED(cut_place);
  typename Formats::rom_begin rom_begin;
  typename Formats::rom_change rom_change;
  typename Formats::mul_place SC_NAMED(mul_place);
  typename Formats::add_line SC_NAMED(add_line);
  typename Formats::quant SC_NAMED(quant);

  net<typename Formats::unity> SC_NAMED(unity);
  net<carry> SC_NAMED(grounded);
  net<typename Formats::versine> SC_NAMED(versine);
  net<typename Formats::half_versine> SC_NAMED(half_versine);
  net<typename Formats::factor> SC_NAMED(factor);
  net<typename Formats::log> SC_NAMED(log_of_cos);
  net<typename Formats::power_log> SC_NAMED(power_log);
  net<typename Formats::limited> SC_NAMED(limited);
  net<typename Formats::index> SC_NAMED(index);
  net<typename Formats::place> SC_NAMED(place);
  net<typename Formats::begin> SC_NAMED(line_begin);
  net<typename Formats::change> SC_NAMED(line_change);
  net<typename Formats::product> SC_NAMED(change_there);
  net<typename Formats::line> SC_NAMED(line);

  explicit table(const sc_core::sc_module_name& name)
      : base(name),
        node1("node1", 1),
        ground("ground", 0),
        rom_begin("rom_begin", 0),
        rom_change("rom_change", 1) {
    static_assert(Formats::no_overflow());
    // clang-format off
    node1.y_o(unity);               ground.y_o(grounded);
    sub_cos.a_i(this->cos_delta);                                                           sub_cos.y_o(versine);
    halve_versine.a_i(versine);                                                             halve_versine.y_o(half_versine);
    add_factor.a_i(unity);          add_factor.b_i(half_versine);  add_factor.carry_i(grounded);  add_factor.s_o(factor);
    mul_log.a_i(versine);           mul_log.b_i(factor);                                    mul_log.p_o(log_of_cos);
    mul_n.a_i(this->n);             mul_n.b_i(log_of_cos);                                  mul_n.p_o(power_log);
    quant_log.a_i(power_log);                                                               quant_log.y_o(limited);
    cut_index.a_i(limited);                                                                 cut_index.y_o(index);
    cut_place.a_i(limited);                                                                 cut_place.y_o(place);
    rom_begin.a_i(index);                                                                   rom_begin.y_o(line_begin);
    rom_change.a_i(index);                                                                  rom_change.y_o(line_change);
    mul_place.a_i(line_change);     mul_place.b_i(place);                                   mul_place.p_o(change_there);
    add_line.a_i(line_begin);       add_line.b_i(change_there);    add_line.carry_i(grounded);    add_line.s_o(line);
    quant.a_i(line);                                                                        quant.y_o(this->brdf);
    // clang-format on
  }

  /// The parts list, for readers of the structure.
  auto blocks() const {
    return std::tuple_cat(
        base::blocks(), std::tie(node1, ground, sub_cos, halve_versine, add_factor, mul_log, mul_n, quant_log,
                                 cut_index, cut_place, rom_begin, rom_change, mul_place, add_line, quant));
  }
};

}  // namespace blysk
