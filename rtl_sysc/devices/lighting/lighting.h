// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/constant.h"
#include "rtl_sysc/blocks/pipe.h"
#include "rtl_sysc/blocks/pipe_control.h"
#include "rtl_sysc/devices/lighting/formats.h"
#include "rtl_sysc/pin.h"

#include <tuple>

namespace blysk {

/// One channel of the lighting unit: a block for each effect, and the accumulator of the lights.
///   sum = min(255, (first ? ambient : sum) + diffuse + specular)
template <class Formats>
struct lighting_channel_base : sc_core::sc_module {
  template <class Q>
  using in = sc_core::sc_in<typename Q::raw_t>;
  template <class Q>
  using out = sc_core::sc_out<typename Q::raw_t>;
  template <class Q>
  using net = sc_core::sc_signal<typename Q::raw_t>;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(take_i);
  sc_core::sc_in<bool> SC_NAMED(first_i);
  in<carry> SC_NAMED(ground_i);
  in<typename Formats::cos_theta> SC_NAMED(nl_i);
  in<typename Formats::coefficient> SC_NAMED(ambient_i);
  in<typename Formats::coefficient> SC_NAMED(diffuse_i);
  in<typename Formats::specular_in> SC_NAMED(specular_i);
  out<typename Formats::level> SC_NAMED(sum_o);
  out<colour> SC_NAMED(channel_o);

  typename Formats::ambient SC_NAMED(ambient);
  typename Formats::diffuse SC_NAMED(diffuse);
  typename Formats::specular SC_NAMED(specular);
  typename Formats::base SC_NAMED(base);
  typename Formats::add_diffuse SC_NAMED(add_diffuse);
  typename Formats::add_specular SC_NAMED(add_specular);
  typename Formats::saturate SC_NAMED(saturate);
  typename Formats::accumulator SC_NAMED(accumulator);
  typename Formats::round SC_NAMED(round);

  net<typename Formats::term> SC_NAMED(ambient_term);
  net<typename Formats::term> SC_NAMED(diffuse_term);
  net<typename Formats::highlight> SC_NAMED(specular_term);
  net<typename Formats::level> SC_NAMED(sum_before);
  net<typename Formats::lit> SC_NAMED(lit);
  net<typename Formats::sum> SC_NAMED(sum);
  net<typename Formats::level> SC_NAMED(level);

  explicit lighting_channel_base(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {
    // clang-format off
    ambient.a_i(ambient_i);                                                             ambient.y_o(ambient_term);
    diffuse.a_i(diffuse_i);     diffuse.b_i(nl_i);                                      diffuse.p_o(diffuse_term);
    base.a_i(sum_o);            base.b_i(ambient_term);   base.select_b_i(first_i);     base.y_o(sum_before);
    add_diffuse.a_i(sum_before);add_diffuse.b_i(diffuse_term);    add_diffuse.carry_i(ground_i);   add_diffuse.s_o(lit);
    add_specular.a_i(lit);      add_specular.b_i(specular_term);  add_specular.carry_i(ground_i);  add_specular.s_o(sum);
    saturate.a_i(sum);                                                                  saturate.y_o(level);
    accumulator.clk(clk);       accumulator.rst_n(rst_n);
    accumulator.d_i(level);     accumulator.we_i(take_i);                               accumulator.q_o(sum_o);
    round.a_i(sum_o);                                                                   round.y_o(channel_o);
    specular.a_i(specular_i);
    // clang-format on
  }

  auto blocks() const {
    return std::tie(ambient, diffuse, specular, base, add_diffuse, add_specular, saturate, accumulator,
                    round);
  }
};

/// The same with the specular term as it comes.
template <class Formats>
struct lighting_channel : lighting_channel_base<Formats> {
  explicit lighting_channel(const sc_core::sc_module_name& name) : lighting_channel_base<Formats>(name) {
    this->specular.y_o(this->specular_term);
  }
};

/// The same with an energy factor that multiplies it.
template <class Formats>
requires(Formats::has_energy) struct lighting_channel<Formats> : lighting_channel_base<Formats> {
  typename lighting_channel_base<Formats>::template in<typename Formats::factor> SC_NAMED(energy_i);

  explicit lighting_channel(const sc_core::sc_module_name& name) : lighting_channel_base<Formats>(name) {
    this->specular.b_i(energy_i);
    this->specular.p_o(this->specular_term);
  }
};

/// The colour of a pixel, [T] (1.2), light by light: beside a specular device, which gives the specular terms.
///   I_a k_a  +  sum over the lights  I_l (k_d N.L + k_s lobe(n, N.H)),   saturated to 0..255
///
/// Formats  Formats: a lighting_formats.
/// Timing   takes a light at a rising edge of clk that sees start_i and ready_o at one; first_i says that it is the first one
///          of a pixel. From then on valid_o is one and the outputs show the pixel with its lights so far, until the next
///          edge, or as long as stall_i is one. A light each cycle.
/// Error    sum_o of a channel: none of the ambient term, 1/2 ulp of UQ8.16 of each product that has more bits; channel_o 1/2
///          besides.
/// Reset    rst_n low at a rising edge of clk: valid_o and the sums 0.
template <class Formats>
struct lighting_base : sc_core::sc_module {
  template <class Q>
  using in = sc_core::sc_in<typename Q::raw_t>;
  template <class Q>
  using out = sc_core::sc_out<typename Q::raw_t>;
  using channel = lighting_channel<Formats>;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  in<typename Formats::cos_theta> SC_NAMED(nl_i);
  in<flag> SC_NAMED(first_i);
  in<typename Formats::coefficient> SC_NAMED(ar_i);
  in<typename Formats::coefficient> SC_NAMED(ag_i);
  in<typename Formats::coefficient> SC_NAMED(ab_i);
  in<typename Formats::coefficient> SC_NAMED(dr_i);
  in<typename Formats::coefficient> SC_NAMED(dg_i);
  in<typename Formats::coefficient> SC_NAMED(db_i);
  in<typename Formats::specular_in> SC_NAMED(sr_i);
  in<typename Formats::specular_in> SC_NAMED(sg_i);
  in<typename Formats::specular_in> SC_NAMED(sb_i);
  sc_core::sc_in<bool> SC_NAMED(start_i);
  sc_core::sc_in<bool> SC_NAMED(stall_i);
  sc_core::sc_out<bool> SC_NAMED(ready_o);
  out<typename Formats::level> SC_NAMED(r_sum_o);
  out<typename Formats::level> SC_NAMED(g_sum_o);
  out<typename Formats::level> SC_NAMED(b_sum_o);
  out<colour> SC_NAMED(r_o);
  out<colour> SC_NAMED(g_o);
  out<colour> SC_NAMED(b_o);
  sc_core::sc_out<bool> SC_NAMED(valid_o);

  pipe_control SC_NAMED(control);
  pipe<single_bit> pipe_valid;
  constant<carry> ground;
  channel SC_NAMED(red);
  channel SC_NAMED(green);
  channel SC_NAMED(blue);

  sc_core::sc_signal<bool> SC_NAMED(go);
  sc_core::sc_signal<bool> SC_NAMED(take);
  sc_core::sc_signal<typename carry::raw_t> SC_NAMED(ground_in);

  explicit lighting_base(const sc_core::sc_module_name& name)
      : sc_core::sc_module(name), pipe_valid("pipe_valid", 1), ground("ground", 0) {
    static_assert(Formats::no_overflow());
    // clang-format off
    control.start_i(start_i);  control.stall_i(stall_i);  control.valid_i(valid_o);
    control.go_o(go);          control.take_o(take);      control.ready_o(ready_o);
    pipe_valid.clk(clk);  pipe_valid.rst_n(rst_n);  pipe_valid.go_i(go);  pipe_valid.d_i(start_i);  pipe_valid.q_o(valid_o);
    ground.y_o(ground_in);
    red.ambient_i(ar_i);    red.diffuse_i(dr_i);    red.specular_i(sr_i);    red.sum_o(r_sum_o);    red.channel_o(r_o);
    green.ambient_i(ag_i);  green.diffuse_i(dg_i);  green.specular_i(sg_i);  green.sum_o(g_sum_o);  green.channel_o(g_o);
    blue.ambient_i(ab_i);   blue.diffuse_i(db_i);   blue.specular_i(sb_i);   blue.sum_o(b_sum_o);   blue.channel_o(b_o);
    // clang-format on
    wire(red);
    wire(green);
    wire(blue);
  }

  /// The ports and what they are for; no seed has a figure of it.
  template <class Reader>
  static void pins(Reader& reader) {
    using d = lighting_base;
    using coefficient = typename Formats::coefficient;
    using specular_in = typename Formats::specular_in;
    using level = typename Formats::level;
    reader.clock(&d::clk, {"clk", "", "clk", "clock"});
    reader.reset(&d::rst_n, {"rst_n", "", "rst_n", "synchronous, active low"});
    reader.data(&d::nl_i, {"nl_i", "", "n_l", "N.L, 0..1"}, typename Formats::cos_theta{}, "nl");
    reader.data(&d::first_i, {"first_i", "", "first", "1: the first light of a pixel"}, flag{}, "first");
    reader.data(&d::ar_i, {"ar_i", "", "red_ambient", "I_a k_a, red"}, coefficient{}, "ar");
    reader.data(&d::ag_i, {"ag_i", "", "green_ambient", "I_a k_a, green"}, coefficient{}, "ag");
    reader.data(&d::ab_i, {"ab_i", "", "blue_ambient", "I_a k_a, blue"}, coefficient{}, "ab");
    reader.data(&d::dr_i, {"dr_i", "", "red_diffuse", "I_l k_d, red"}, coefficient{}, "dr");
    reader.data(&d::dg_i, {"dg_i", "", "green_diffuse", "I_l k_d, green"}, coefficient{}, "dg");
    reader.data(&d::db_i, {"db_i", "", "blue_diffuse", "I_l k_d, blue"}, coefficient{}, "db");
    reader.data(&d::sr_i, {"sr_i", "", "red_specular", "output 25 of a specular device"}, specular_in{},
                "sr");
    reader.data(&d::sg_i, {"sg_i", "", "green_specular", "output 26 of a specular device"}, specular_in{},
                "sg");
    reader.data(&d::sb_i, {"sb_i", "", "blue_specular", "output 27 of a specular device"}, specular_in{},
                "sb");
    reader.start(&d::start_i, {"start_i", "", "start", "takes a light while ready_o is one"});
    reader.control(&d::stall_i, {"stall_i", "", "stall", "keeps a result at the outputs"});
    reader.ready(&d::ready_o, {"ready_o", "", "ready", "start_i takes a light"});
    reader.result(&d::r_sum_o, {"r_sum_o", "", "sum_red", "red, with its fraction"}, level{}, "red_sum");
    reader.result(&d::g_sum_o, {"g_sum_o", "", "sum_green", "green, with its fraction"}, level{},
                  "green_sum");
    reader.result(&d::b_sum_o, {"b_sum_o", "", "sum_blue", "blue, with its fraction"}, level{}, "blue_sum");
    reader.result(&d::r_o, {"r_o", "", "out_red", "red of the pixel"}, colour{}, "red");
    reader.result(&d::g_o, {"g_o", "", "out_green", "green of the pixel"}, colour{}, "green");
    reader.result(&d::b_o, {"b_o", "", "out_blue", "blue of the pixel"}, colour{}, "blue");
    reader.valid(&d::valid_o, {"valid_o", "", "valid", "a result is at the outputs"});
  }

  /// The leaf parts, for the same readers.
  auto blocks() const {
    return std::tuple_cat(std::tie(control, pipe_valid, ground), red.blocks(), green.blocks(), blue.blocks());
  }

 private:
  void wire(channel& each) {
    each.clk(clk);
    each.rst_n(rst_n);
    each.take_i(take);
    each.first_i(first_i);
    each.ground_i(ground_in);
    each.nl_i(nl_i);
  }
};

/// The same as a device.
template <class Formats>
struct lighting : lighting_base<Formats> {
  explicit lighting(const sc_core::sc_module_name& name) : lighting_base<Formats>(name) {}
};

/// The same with an energy factor, which multiplies the specular terms of a light.
template <class Formats>
requires(Formats::has_energy) struct lighting<Formats> : lighting_base<Formats> {
  typename lighting_base<Formats>::template in<typename Formats::factor> SC_NAMED(energy_i);

  explicit lighting(const sc_core::sc_module_name& name) : lighting_base<Formats>(name) {
    this->red.energy_i(energy_i);
    this->green.energy_i(energy_i);
    this->blue.energy_i(energy_i);
  }

  template <class Reader>
  static void pins(Reader& reader) {
    lighting_base<Formats>::pins(reader);
    reader.data(&lighting::energy_i, {"energy_i", "", "energy", "energy factor of the specular terms, 0..41"},
                typename Formats::factor{}, "energy");
  }
};

}  // namespace blysk
