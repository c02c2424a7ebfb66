// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/constant.h"
#include "rtl_sysc/devices/gouraud/formats.h"
#include "rtl_sysc/pin.h"

#include <tuple>

namespace blysk {

/// One channel: the increment by the accumulating adder of [T] fig. 2.13, then an accumulator of pixels.
template <class Formats>
struct gouraud_channel : sc_core::sc_module {
  template <class Q>
  using in = sc_core::sc_in<typename Q::raw_t>;
  template <class Q>
  using net = sc_core::sc_signal<typename Q::raw_t>;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(load_i);
  sc_core::sc_in<bool> SC_NAMED(step_i);
  sc_core::sc_in<bool> SC_NAMED(draw_i);
  sc_core::sc_in<bool> SC_NAMED(digit_i);
  in<carry> SC_NAMED(one_i);
  in<carry> SC_NAMED(ground_i);
  in<colour> SC_NAMED(left_i);
  in<colour> SC_NAMED(right_i);
  sc_core::sc_out<typename colour::raw_t> SC_NAMED(pixel_o);

  typename Formats::inv_left SC_NAMED(inv_left);
  typename Formats::add_difference SC_NAMED(add_difference);
  typename Formats::rg_shift SC_NAMED(rg_shift);
  typename Formats::add_sum SC_NAMED(add_sum);
  typename Formats::rg_sum SC_NAMED(rg_sum);
  typename Formats::add_pixel SC_NAMED(add_pixel);
  typename Formats::rg_pixel SC_NAMED(rg_pixel);
  typename Formats::quant_pixel SC_NAMED(quant_pixel);

  net<typename Formats::inverted> SC_NAMED(inverted);
  net<intensity_difference> SC_NAMED(difference);
  net<typename Formats::shifted> SC_NAMED(shifted);
  net<typename Formats::increment> SC_NAMED(sum);
  net<typename Formats::increment> SC_NAMED(increment);
  net<typename Formats::intensity> SC_NAMED(next);
  net<typename Formats::intensity> SC_NAMED(intensity);

  SC_CTOR(gouraud_channel) {
    // clang-format off
    inv_left.a_i(left_i);                                                                inv_left.y_o(inverted);
    add_difference.a_i(right_i);  add_difference.b_i(inverted);  add_difference.carry_i(one_i);
    add_difference.s_o(difference);
    rg_shift.clk(clk);  rg_shift.rst_n(rst_n);  rg_shift.load_i(load_i);  rg_shift.step_i(step_i);
    rg_shift.d_i(difference);                                                            rg_shift.q_o(shifted);
    add_sum.a_i(increment);   add_sum.b_i(shifted);     add_sum.carry_i(ground_i);       add_sum.s_o(sum);
    rg_sum.clk(clk);    rg_sum.rst_n(rst_n);    rg_sum.load_i(load_i);    rg_sum.step_i(step_i);
    rg_sum.add_i(digit_i);    rg_sum.d_i(difference);   rg_sum.sum_i(sum);               rg_sum.q_o(increment);
    add_pixel.a_i(intensity); add_pixel.b_i(increment); add_pixel.carry_i(ground_i);     add_pixel.s_o(next);
    rg_pixel.clk(clk);  rg_pixel.rst_n(rst_n);  rg_pixel.load_i(load_i);  rg_pixel.step_i(draw_i);
    rg_pixel.d_i(left_i);     rg_pixel.sum_i(next);                                      rg_pixel.q_o(intensity);
    quant_pixel.a_i(intensity);                                                          quant_pixel.y_o(pixel_o);
    // clang-format on
  }

  auto blocks() const {
    return std::tie(inv_left, add_difference, rg_shift, add_sum, rg_sum, add_pixel, rg_pixel, quant_pixel);
  }
};

/// Gouraud shading of a scan line, [T] 2.4: three channels, the digits of 1/length from one memory.
///   pixel x = left + x (right - left) / length, x = 0..length, rounded to nearest
///
/// Formats  Formats: a gouraud_formats.
/// Timing   takes its inputs at a rising edge of clk that sees start_i and ready_o at one; `steps` cycles later the first
///          pixel is at the outputs; valid_o is one for length + 1 cycles, one pixel each.
/// Reset    rst_n low at a rising edge of clk: ready, all registers 0.
template <class Formats>
struct gouraud : sc_core::sc_module {
  template <class Q>
  using in = sc_core::sc_in<typename Q::raw_t>;
  template <class Q>
  using out = sc_core::sc_out<typename Q::raw_t>;
  template <class Q>
  using net = sc_core::sc_signal<typename Q::raw_t>;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  in<run_length> SC_NAMED(length_i);
  in<colour> SC_NAMED(r0_i);
  in<colour> SC_NAMED(g0_i);
  in<colour> SC_NAMED(b0_i);
  in<colour> SC_NAMED(r1_i);
  in<colour> SC_NAMED(g1_i);
  in<colour> SC_NAMED(b1_i);
  sc_core::sc_in<bool> SC_NAMED(start_i);
  sc_core::sc_out<bool> SC_NAMED(ready_o);
  out<colour> SC_NAMED(r_o);
  out<colour> SC_NAMED(g_o);
  out<colour> SC_NAMED(b_o);
  sc_core::sc_out<bool> SC_NAMED(valid_o);

  typename Formats::control SC_NAMED(control);
  typename Formats::rom_digits rom_digits;
  typename Formats::rg_digits SC_NAMED(rg_digits);
  constant<carry> one;
  constant<carry> ground;
  gouraud_channel<Formats> SC_NAMED(red);
  gouraud_channel<Formats> SC_NAMED(green);
  gouraud_channel<Formats> SC_NAMED(blue);

  sc_core::sc_signal<bool> SC_NAMED(load);
  sc_core::sc_signal<bool> SC_NAMED(step);
  sc_core::sc_signal<bool> SC_NAMED(digit);
  net<typename Formats::digits> SC_NAMED(digits);
  net<carry> SC_NAMED(one_in);
  net<carry> SC_NAMED(ground_in);

  explicit gouraud(const sc_core::sc_module_name& name)
      : sc_core::sc_module(name), rom_digits("rom_digits", 0), one("one", 1), ground("ground", 0) {
    static_assert(Formats::no_overflow());
    // clang-format off
    control.clk(clk);    control.rst_n(rst_n);    control.start_i(start_i);  control.length_i(length_i);
    control.load_o(load);  control.step_o(step);  control.draw_o(valid_o);   control.ready_o(ready_o);
    rom_digits.a_i(length_i);                                                         rom_digits.y_o(digits);
    rg_digits.clk(clk);  rg_digits.rst_n(rst_n);  rg_digits.load_i(load);    rg_digits.step_i(step);
    rg_digits.d_i(digits);                                                            rg_digits.digit_o(digit);
    one.y_o(one_in);     ground.y_o(ground_in);
    // clang-format on
    wire(red, r0_i, r1_i, r_o);
    wire(green, g0_i, g1_i, g_o);
    wire(blue, b0_i, b1_i, b_o);
  }

  /// The ports and what they are for; the figures give them no numbers.
  template <class Reader>
  static void pins(Reader& reader) {
    using d = gouraud;
    reader.clock(&d::clk, {"clk", "", "clk", "clock"});
    reader.reset(&d::rst_n, {"rst_n", "", "rst_n", "synchronous, active low"});
    reader.data(&d::length_i, {"length_i", "", "length", "pixels from the left end to the right one"},
                run_length{}, "length");
    reader.data(&d::r0_i, {"r0_i", "", "red_left", "red at the left end"}, colour{}, "r0");
    reader.data(&d::g0_i, {"g0_i", "", "green_left", "green at the left end"}, colour{}, "g0");
    reader.data(&d::b0_i, {"b0_i", "", "blue_left", "blue at the left end"}, colour{}, "b0");
    reader.data(&d::r1_i, {"r1_i", "", "red_right", "red at the right end"}, colour{}, "r1");
    reader.data(&d::g1_i, {"g1_i", "", "green_right", "green at the right end"}, colour{}, "g1");
    reader.data(&d::b1_i, {"b1_i", "", "blue_right", "blue at the right end"}, colour{}, "b1");
    reader.start(&d::start_i, {"start_i", "", "start", "takes the inputs while ready_o is one"});
    reader.ready(&d::ready_o, {"ready_o", "", "ready", "start_i takes the inputs"});
    reader.result(&d::r_o, {"r_o", "", "out_red", "red of the pixel"}, colour{}, "red");
    reader.result(&d::g_o, {"g_o", "", "out_green", "green of the pixel"}, colour{}, "green");
    reader.result(&d::b_o, {"b_o", "", "out_blue", "blue of the pixel"}, colour{}, "blue");
    reader.valid(&d::valid_o, {"valid_o", "", "valid", "a pixel is at the outputs"});
  }

  /// The leaf parts, for the same readers.
  auto blocks() const {
    return std::tuple_cat(std::tie(control, rom_digits, rg_digits, one, ground), red.blocks(), green.blocks(),
                          blue.blocks());
  }

 private:
  void wire(gouraud_channel<Formats>& channel, in<colour>& left, in<colour>& right, out<colour>& pixel) {
    // clang-format off
    channel.clk(clk);      channel.rst_n(rst_n);  channel.load_i(load);    channel.step_i(step);
    channel.draw_i(valid_o);  channel.digit_i(digit);  channel.one_i(one_in);  channel.ground_i(ground_in);
    channel.left_i(left);  channel.right_i(right);                         channel.pixel_o(pixel);
    // clang-format on
  }
};

}  // namespace blysk
