// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/constant.h"
#include "rtl_sysc/devices/quadratic_interpolation/formats.h"
#include "rtl_sysc/pin.h"

#include <tuple>

namespace blysk {

/// One channel: two adders, which form the next pixel's intensity and first difference.
template <class Formats>
struct forward_differences : sc_core::sc_module {
  template <class Q>
  using in = sc_core::sc_in<typename Q::raw_t>;
  template <class Q>
  using net = sc_core::sc_signal<typename Q::raw_t>;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(load_i);
  sc_core::sc_in<bool> SC_NAMED(draw_i);
  in<carry> SC_NAMED(ground_i);
  in<typename Formats::value_in> SC_NAMED(value_i);
  in<typename Formats::first_in> SC_NAMED(first_i);
  in<typename Formats::second_in> SC_NAMED(second_i);
  sc_core::sc_out<typename colour::raw_t> SC_NAMED(pixel_o);

  typename Formats::rg_second SC_NAMED(rg_second);
  typename Formats::rg_first SC_NAMED(rg_first);
  typename Formats::rg_value SC_NAMED(rg_value);
  typename Formats::add_first SC_NAMED(add_first);
  typename Formats::add_value SC_NAMED(add_value);
  typename Formats::quant SC_NAMED(quant);

  net<typename Formats::second> SC_NAMED(second);
  net<typename Formats::first> SC_NAMED(first);
  net<typename Formats::first> SC_NAMED(next_first);
  net<typename Formats::value> SC_NAMED(value);
  net<typename Formats::value> SC_NAMED(next_value);

  SC_CTOR(forward_differences) {
    // clang-format off
    rg_second.clk(clk);  rg_second.rst_n(rst_n);  rg_second.load_i(load_i);  rg_second.step_i(draw_i);
    rg_second.d_i(second_i);  rg_second.sum_i(second);                           rg_second.q_o(second);
    rg_first.clk(clk);   rg_first.rst_n(rst_n);   rg_first.load_i(load_i);   rg_first.step_i(draw_i);
    rg_first.d_i(first_i);    rg_first.sum_i(next_first);                        rg_first.q_o(first);
    rg_value.clk(clk);   rg_value.rst_n(rst_n);   rg_value.load_i(load_i);   rg_value.step_i(draw_i);
    rg_value.d_i(value_i);    rg_value.sum_i(next_value);                        rg_value.q_o(value);
    add_first.a_i(first);     add_first.b_i(second);  add_first.carry_i(ground_i);  add_first.s_o(next_first);
    add_value.a_i(value);     add_value.b_i(first);   add_value.carry_i(ground_i);  add_value.s_o(next_value);
    quant.a_i(value);                                                            quant.y_o(pixel_o);
    // clang-format on
  }

  auto blocks() const { return std::tie(rg_second, rg_first, rg_value, add_first, add_value, quant); }
};

/// Quadratic interpolation along a scan line by forward differences, two adders for each channel ([T] listing A,
/// Quadratic_Interpolation, evaluates the polynomial anew for each pixel).
///   pixel x = value + x first + x (x - 1)/2 second, x = 0..length, rounded to nearest, limited to 0..255
///
/// Formats  Formats: a quadratic_interpolation_formats.
/// Timing   takes its inputs at a rising edge of clk that sees start_i and ready_o at one; from the next cycle on valid_o is
///          one for length + 1 cycles, one pixel each.
/// Reset    rst_n low at a rising edge of clk: ready, all registers 0.
template <class Formats>
struct quadratic_interpolation : sc_core::sc_module {
  template <class Q>
  using in = sc_core::sc_in<typename Q::raw_t>;
  template <class Q>
  using out = sc_core::sc_out<typename Q::raw_t>;
  using channel = forward_differences<Formats>;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  in<line_length> SC_NAMED(length_i);
  in<typename Formats::value_in> SC_NAMED(r_i);
  in<typename Formats::first_in> SC_NAMED(dr_i);
  in<typename Formats::second_in> SC_NAMED(ddr_i);
  in<typename Formats::value_in> SC_NAMED(g_i);
  in<typename Formats::first_in> SC_NAMED(dg_i);
  in<typename Formats::second_in> SC_NAMED(ddg_i);
  in<typename Formats::value_in> SC_NAMED(b_i);
  in<typename Formats::first_in> SC_NAMED(db_i);
  in<typename Formats::second_in> SC_NAMED(ddb_i);
  sc_core::sc_in<bool> SC_NAMED(start_i);
  sc_core::sc_out<bool> SC_NAMED(ready_o);
  out<colour> SC_NAMED(r_o);
  out<colour> SC_NAMED(g_o);
  out<colour> SC_NAMED(b_o);
  sc_core::sc_out<bool> SC_NAMED(valid_o);

  typename Formats::control SC_NAMED(control);
  constant<carry> ground;
  channel SC_NAMED(red);
  channel SC_NAMED(green);
  channel SC_NAMED(blue);

  sc_core::sc_signal<bool> SC_NAMED(load);
  sc_core::sc_signal<typename carry::raw_t> SC_NAMED(ground_in);

  explicit quadratic_interpolation(const sc_core::sc_module_name& name)
      : sc_core::sc_module(name), ground("ground", 0) {
    static_assert(Formats::no_overflow());
    // clang-format off
    control.clk(clk);      control.rst_n(rst_n);  control.start_i(start_i);  control.length_i(length_i);
    control.load_o(load);  control.draw_o(valid_o);                      control.ready_o(ready_o);
    ground.y_o(ground_in);
    red.value_i(r_i);    red.first_i(dr_i);    red.second_i(ddr_i);    red.pixel_o(r_o);
    green.value_i(g_i);  green.first_i(dg_i);  green.second_i(ddg_i);  green.pixel_o(g_o);
    blue.value_i(b_i);   blue.first_i(db_i);   blue.second_i(ddb_i);   blue.pixel_o(b_o);
    // clang-format on
    wire(red);
    wire(green);
    wire(blue);
  }

  /// The ports and what they are for; [T] has no figure of it.
  template <class Reader>
  static void pins(Reader& reader) {
    using d = quadratic_interpolation;
    using value = typename Formats::value_in;
    using first = typename Formats::first_in;
    using second = typename Formats::second_in;
    reader.clock(&d::clk, {"clk", "", "clk", "clock"});
    reader.reset(&d::rst_n, {"rst_n", "", "rst_n", "synchronous, active low"});
    reader.data(&d::length_i, {"length_i", "", "length", "pixels after the first"}, line_length{}, "length");
    reader.data(&d::r_i, {"r_i", "", "red", "red of the first pixel"}, value{}, "r");
    reader.data(&d::dr_i, {"dr_i", "", "red_first", "its first difference"}, first{}, "dr");
    reader.data(&d::ddr_i, {"ddr_i", "", "red_second", "its second difference"}, second{}, "ddr");
    reader.data(&d::g_i, {"g_i", "", "green", "green of the first pixel"}, value{}, "g");
    reader.data(&d::dg_i, {"dg_i", "", "green_first", "its first difference"}, first{}, "dg");
    reader.data(&d::ddg_i, {"ddg_i", "", "green_second", "its second difference"}, second{}, "ddg");
    reader.data(&d::b_i, {"b_i", "", "blue", "blue of the first pixel"}, value{}, "b");
    reader.data(&d::db_i, {"db_i", "", "blue_first", "its first difference"}, first{}, "db");
    reader.data(&d::ddb_i, {"ddb_i", "", "blue_second", "its second difference"}, second{}, "ddb");
    reader.start(&d::start_i, {"start_i", "", "start", "takes the inputs while ready_o is one"});
    reader.ready(&d::ready_o, {"ready_o", "", "ready", "start_i takes the inputs"});
    reader.result(&d::r_o, {"r_o", "", "out_red", "red of the pixel"}, colour{}, "red");
    reader.result(&d::g_o, {"g_o", "", "out_green", "green of the pixel"}, colour{}, "green");
    reader.result(&d::b_o, {"b_o", "", "out_blue", "blue of the pixel"}, colour{}, "blue");
    reader.valid(&d::valid_o, {"valid_o", "", "valid", "a pixel is at the outputs"});
  }

  /// The leaf parts, for the same readers.
  auto blocks() const {
    return std::tuple_cat(std::tie(control, ground), red.blocks(), green.blocks(), blue.blocks());
  }

 private:
  void wire(channel& each) {
    each.clk(clk);
    each.rst_n(rst_n);
    each.load_i(load);
    each.draw_i(valid_o);
    each.ground_i(ground_in);
  }
};

}  // namespace blysk
