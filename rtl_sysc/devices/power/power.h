// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/constant.h"
#include "rtl_sysc/devices/power/formats.h"
#include "rtl_sysc/devices/specular.h"

namespace blysk {

/// The power of Blinn's model itself, in the place of the parabola of [P] fig. 1: logarithm, multiplication, and power of
/// two.
///   (r_o, g_o, b_o) = brdf * (R, G, B) k_s,   brdf = c^n = 2^(-n (-log2 c)), within 1 ulp
///   c = 2^-(z+1) (1 + f),   -log2 c = z + (1 - f) ratio(f),   ratio(f) = (1 - log2(1 + f))/(1 - f)
/// The ratio and 2^-x are lines between the words of memories. The factor 1 - f keeps the relative accuracy of the
/// logarithm down to 0 at c = 1, where n = 1000 needs it.
/// Ports, timing and reset are those of specular_device.
/// \tparam Formats  a power_formats
/// \tparam Base     specular_device, or pipelined_device with these levels: 0 norm, 1 add_f and the memories of the ratio,
///                  2 mul_ratio, 3 add_ratio, 4 mul_log, 5 add_log, 6 mul_n, 7 the memories of the power, 8 mul_power,
///                  9 add_power, 10 shift, 11 quant key_brdf, 12 mul12 mul13 mul14
template <class Formats, class Base = specular_device<Formats>>
struct power : Base {
  using base = Base;
  template <class Q>
  using staged = typename base::template staged<Q>;
  using ratios = typename Formats::ratios;
  using powers = typename Formats::powers;
  template <class Q>
  using net = typename base::template net<Q>;

  constant<typename Formats::two> node2;
  constant<carry> carry_f;
  constant<carry> ground;
  typename Formats::norm SC_NAMED(norm);
  typename Formats::inv_f SC_NAMED(inv_f);
  typename Formats::add_f SC_NAMED(add_f);
  typename Formats::index_ratio SC_NAMED(index_ratio);
  typename Formats::place_ratio SC_NAMED(place_ratio);
  typename ratios::rom_begin rom_ratio;
  typename ratios::rom_change rom_ratio_change;
  typename ratios::mul_place SC_NAMED(mul_ratio);
  typename ratios::add_line SC_NAMED(add_ratio);
  typename ratios::cut_line SC_NAMED(cut_ratio);
  typename Formats::mul_log SC_NAMED(mul_log);
  typename Formats::cut_log SC_NAMED(cut_log);
  typename Formats::add_log SC_NAMED(add_log);
  typename Formats::mul_n SC_NAMED(mul_n);
  typename Formats::cut_above SC_NAMED(cut_above);
  typename Formats::cut_places SC_NAMED(cut_places);
  typename Formats::index_power SC_NAMED(index_power);
  typename Formats::place_power SC_NAMED(place_power);
  typename powers::rom_begin rom_power;
  typename powers::rom_change rom_power_change;
  typename powers::mul_place SC_NAMED(mul_power);
  typename powers::add_line SC_NAMED(add_power);
  typename powers::cut_line SC_NAMED(cut_power);
  typename Formats::shift SC_NAMED(shift);
  typename Formats::quant SC_NAMED(quant);
  typename Formats::off SC_NAMED(off);
  typename Formats::key_brdf SC_NAMED(key_brdf);

  net<typename Formats::two> SC_NAMED(two);
  net<carry> SC_NAMED(carry_one);
  net<carry> SC_NAMED(grounded);
  net<typename Formats::normalised> SC_NAMED(normalised);
  net<typename Formats::zeros> SC_NAMED(zeros);
  net<single_bit> SC_NAMED(is_zero);
  net<typename Formats::inverted> SC_NAMED(inverted);
  net<typename Formats::distance> SC_NAMED(distance);
  net<typename ratios::index> SC_NAMED(ratio_index);
  net<typename ratios::place> SC_NAMED(ratio_place);
  net<typename ratios::begin> SC_NAMED(ratio_begin);
  net<typename ratios::change> SC_NAMED(ratio_change);
  net<typename ratios::product> SC_NAMED(ratio_product);
  net<typename ratios::line> SC_NAMED(ratio_line);
  net<typename Formats::ratio> SC_NAMED(ratio);
  net<typename Formats::log_product> SC_NAMED(log_product);
  net<typename Formats::log_fraction> SC_NAMED(log_fraction);
  net<typename Formats::log> SC_NAMED(minus_log_cos);
  net<typename Formats::power_log> SC_NAMED(minus_log_power);
  net<typename Formats::above> SC_NAMED(above);
  net<typename Formats::places> SC_NAMED(places);
  net<typename powers::index> SC_NAMED(power_index);
  net<typename powers::place> SC_NAMED(power_place);
  net<typename powers::begin> SC_NAMED(power_begin);
  net<typename powers::change> SC_NAMED(power_change);
  net<typename powers::product> SC_NAMED(power_product);
  net<typename powers::line> SC_NAMED(power_line);
  net<typename Formats::power> SC_NAMED(power_of_fraction);
  net<typename Formats::power> SC_NAMED(shifted);
  net<typename Formats::brdf> SC_NAMED(rounded);
  net<single_bit> SC_NAMED(is_off);

  staged<typename Formats::n> n_6{"pipe_n", "n_6", 0, 6};
  staged<typename Formats::normalised> normalised_1{"pipe_normalised", "normalised_1", 0, 1};
  staged<typename Formats::zeros> zeros_5{"pipe_zeros", "zeros_5", 0, 5};
  staged<single_bit> is_zero_7{"pipe_is_zero", "is_zero_7", 0, 7};
  staged<typename Formats::distance> distance_4{"pipe_distance", "distance_4", 1, 4};
  staged<typename ratios::begin> ratio_begin_3{"pipe_ratio_begin", "ratio_begin_3", 1, 3};
  staged<typename ratios::change> ratio_change_2{"pipe_ratio_change", "ratio_change_2", 1, 2};
  staged<typename ratios::place> ratio_place_2{"pipe_ratio_place", "ratio_place_2", 1, 2};
  staged<typename ratios::product> ratio_product_3{"pipe_ratio_product", "ratio_product_3", 2, 3};
  staged<typename Formats::ratio> ratio_4{"pipe_ratio", "ratio_4", 3, 4};
  staged<typename Formats::log_fraction> log_fraction_5{"pipe_log_fraction", "log_fraction_5", 4, 5};
  staged<typename Formats::log> log_6{"pipe_log", "log_6", 5, 6};
  staged<typename Formats::power_log> power_log_7{"pipe_power_log", "power_log_7", 6, 7};
  staged<typename Formats::places> places_10{"pipe_places", "places_10", 7, 10};
  staged<typename powers::begin> power_begin_9{"pipe_power_begin", "power_begin_9", 7, 9};
  staged<typename powers::change> power_change_8{"pipe_power_change", "power_change_8", 7, 8};
  staged<typename powers::place> power_place_8{"pipe_power_place", "power_place_8", 7, 8};
  staged<typename powers::product> power_product_9{"pipe_power_product", "power_product_9", 8, 9};
  staged<typename Formats::power> power_10{"pipe_power", "power_10", 9, 10};
  staged<typename Formats::power> shifted_11{"pipe_shifted", "shifted_11", 10, 11};
  staged<single_bit> is_off_11{"pipe_is_off", "is_off_11", 7, 11};

  /// \param cuts  of a pipelined_device
  template <class... Cuts>
  explicit power(const sc_core::sc_module_name& name, const Cuts&... cuts)
      : base(name, cuts...),
        node2("node2", 2),
        carry_f("carry_f", 1),
        ground("ground", 0),
        rom_ratio("rom_ratio", 0),
        rom_ratio_change("rom_ratio_change", 1),
        rom_power("rom_power", 0),
        rom_power_change("rom_power_change", 1) {
    static_assert(Formats::no_overflow());
    auto& mantissa = this->at(normalised_1, normalised);
    auto& exponent_of_two = this->at(power_log_7, minus_log_power);
    // clang-format off
    node2.y_o(two);  carry_f.y_o(carry_one);  ground.y_o(grounded);
    norm.a_i(this->cos_delta);  norm.m_o(normalised);  norm.zeros_o(zeros);  norm.zero_o(is_zero);
    inv_f.a_i(mantissa);  inv_f.y_o(inverted);
    add_f.a_i(two);  add_f.b_i(inverted);  add_f.carry_i(carry_one);  add_f.s_o(distance);

    index_ratio.a_i(mantissa);  index_ratio.y_o(ratio_index);
    place_ratio.a_i(mantissa);  place_ratio.y_o(ratio_place);
    rom_ratio.a_i(ratio_index);  rom_ratio.y_o(ratio_begin);
    rom_ratio_change.a_i(ratio_index);  rom_ratio_change.y_o(ratio_change);
    mul_ratio.a_i(this->at(ratio_change_2, ratio_change));  mul_ratio.b_i(this->at(ratio_place_2, ratio_place));  mul_ratio.p_o(ratio_product);
    add_ratio.a_i(this->at(ratio_begin_3, ratio_begin));  add_ratio.b_i(this->at(ratio_product_3, ratio_product));  add_ratio.carry_i(grounded);  add_ratio.s_o(ratio_line);
    cut_ratio.a_i(ratio_line);  cut_ratio.y_o(ratio);

    mul_log.a_i(this->at(distance_4, distance));  mul_log.b_i(this->at(ratio_4, ratio));  mul_log.p_o(log_product);
    cut_log.a_i(log_product);  cut_log.y_o(log_fraction);
    add_log.a_i(this->at(zeros_5, zeros));  add_log.b_i(this->at(log_fraction_5, log_fraction));  add_log.carry_i(grounded);  add_log.s_o(minus_log_cos);
    mul_n.a_i(this->at(n_6, this->n));  mul_n.b_i(this->at(log_6, minus_log_cos));  mul_n.p_o(minus_log_power);

    cut_above.a_i(exponent_of_two);  cut_above.y_o(above);
    cut_places.a_i(exponent_of_two);  cut_places.y_o(places);
    index_power.a_i(exponent_of_two);  index_power.y_o(power_index);
    place_power.a_i(exponent_of_two);  place_power.y_o(power_place);
    rom_power.a_i(power_index);  rom_power.y_o(power_begin);
    rom_power_change.a_i(power_index);  rom_power_change.y_o(power_change);
    mul_power.a_i(this->at(power_change_8, power_change));  mul_power.b_i(this->at(power_place_8, power_place));  mul_power.p_o(power_product);
    add_power.a_i(this->at(power_begin_9, power_begin));  add_power.b_i(this->at(power_product_9, power_product));  add_power.carry_i(grounded);  add_power.s_o(power_line);
    cut_power.a_i(power_line);  cut_power.y_o(power_of_fraction);

    shift.a_i(this->at(power_10, power_of_fraction));  shift.places_i(this->at(places_10, places));  shift.y_o(shifted);
    quant.a_i(this->at(shifted_11, shifted));  quant.y_o(rounded);
    off.a_i(above);  off.b_i(this->at(is_zero_7, is_zero));  off.y_o(is_off);
    key_brdf.a_i(rounded);  key_brdf.off_i(this->at(is_off_11, is_off));  key_brdf.y_o(this->before(this->brdf_first, this->brdf));
    // clang-format on
  }

  /// The parts list, for readers of the structure.
  auto blocks() const {
    return std::tuple_cat(
        base::blocks(),
        std::tie(node2, carry_f, ground, norm, inv_f, add_f, index_ratio, place_ratio, rom_ratio,
                 rom_ratio_change, mul_ratio, add_ratio, cut_ratio, mul_log, cut_log, add_log, mul_n,
                 cut_above, cut_places, index_power, place_power, rom_power, rom_power_change, mul_power,
                 add_power, cut_power, shift, quant, off, key_brdf),
        std::tie(n_6.registers, normalised_1.registers, zeros_5.registers, is_zero_7.registers,
                 distance_4.registers, ratio_begin_3.registers, ratio_change_2.registers,
                 ratio_place_2.registers, ratio_product_3.registers, ratio_4.registers,
                 log_fraction_5.registers, log_6.registers, power_log_7.registers, places_10.registers,
                 power_begin_9.registers, power_change_8.registers, power_place_8.registers,
                 power_product_9.registers, power_10.registers, shifted_11.registers, is_off_11.registers));
  }
};

}  // namespace blysk
