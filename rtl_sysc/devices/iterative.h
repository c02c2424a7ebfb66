// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/digit_control.h"
#include "rtl_sysc/blocks/divide_steps.h"
#include "rtl_sysc/devices/specular.h"

namespace blysk {

/// What devices that shade a point by a quotient, a digit of it each clock cycle, have in common, in the place of
/// specular_device: registers, colour multipliers and outputs of [P] fig. 1, without its strobes.
///
/// Formats  Formats::n, ::cos_delta, ::div, ::brdf, ::out; colours in are UQ8.0. Formats::div is the row of subtractors that
///          the other device has; the quotient is that row's.
/// Timing   takes its inputs at a rising edge of clk that sees start_i and ready_o at one; a digit is found in each of the
///          cycles after it. The results are valid in the one cycle in which valid_o is at one, digits + 1 rising edges after
///          the one that took the inputs, when the next ones can be taken. They stay until then.
/// Reset    rst_n low at a rising edge of clk: ready, all registers 0; what was under way is lost.
/// \tparam Figure  names and numbers of the figure, as patent_figure has them
template <class Formats, class Figure = patent_figure>
struct iterative_device : sc_core::sc_module {
  template <class Q>
  using in = sc_core::sc_in<typename Q::raw_t>;
  template <class Q>
  using out = sc_core::sc_out<typename Q::raw_t>;
  template <class Q>
  using net = sc_core::sc_signal<typename Q::raw_t>;
  template <class Row>
  using divider = typename in_steps<Row>::type;
  using mul_colour = mul<typename Formats::brdf, colour, typename Formats::out>;
  static constexpr int digits = divider<typename Formats::div>::steps + 1;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  in<typename Formats::n> SC_NAMED(n_i);
  in<typename Formats::cos_delta> SC_NAMED(cos_i);
  in<colour> SC_NAMED(r_i);
  in<colour> SC_NAMED(g_i);
  in<colour> SC_NAMED(b_i);
  sc_core::sc_in<bool> SC_NAMED(start_i);
  sc_core::sc_out<bool> SC_NAMED(ready_o);
  out<typename Formats::out> SC_NAMED(r_o);
  out<typename Formats::out> SC_NAMED(g_o);
  out<typename Formats::out> SC_NAMED(b_o);
  sc_core::sc_out<bool> SC_NAMED(valid_o);

  digit_control<digits> SC_NAMED(control);
  reg_level<typename Formats::n> rg_n;
  reg_level<typename Formats::cos_delta> rg_cos;
  reg_level<colour> SC_NAMED(rg3);
  reg_level<colour> SC_NAMED(rg4);
  reg_level<colour> SC_NAMED(rg5);
  mul_colour mul_red;
  mul_colour mul_green;
  mul_colour mul_blue;

  sc_core::sc_signal<bool> SC_NAMED(take);
  sc_core::sc_signal<bool> SC_NAMED(first);
  sc_core::sc_signal<bool> SC_NAMED(step);
  net<typename Formats::n> SC_NAMED(n);
  net<typename Formats::cos_delta> SC_NAMED(cos_delta);
  net<colour> SC_NAMED(r_ks);
  net<colour> SC_NAMED(g_ks);
  net<colour> SC_NAMED(b_ks);
  net<typename Formats::brdf> SC_NAMED(brdf);

  explicit iterative_device(const sc_core::sc_module_name& name)
      : sc_core::sc_module(name),
        rg_n(Figure::rg_n),
        rg_cos(Figure::rg_cos),
        mul_red(Figure::mul_red),
        mul_green(Figure::mul_green),
        mul_blue(Figure::mul_blue) {
    // clang-format off
    control.clk(clk);   control.rst_n(rst_n);  control.start_i(start_i);  control.take_o(take);
    control.first_o(first);  control.step_o(step);  control.ready_o(ready_o);  control.done_o(valid_o);
    rg_n.clk(clk);      rg_n.rst_n(rst_n);    rg_n.d_i(n_i);      rg_n.we_i(take);      rg_n.q_o(n);
    rg_cos.clk(clk);    rg_cos.rst_n(rst_n);  rg_cos.d_i(cos_i);  rg_cos.we_i(take);    rg_cos.q_o(cos_delta);
    rg3.clk(clk);       rg3.rst_n(rst_n);     rg3.d_i(r_i);       rg3.we_i(take);       rg3.q_o(r_ks);
    rg4.clk(clk);       rg4.rst_n(rst_n);     rg4.d_i(g_i);       rg4.we_i(take);       rg4.q_o(g_ks);
    rg5.clk(clk);       rg5.rst_n(rst_n);     rg5.d_i(b_i);       rg5.we_i(take);       rg5.q_o(b_ks);
    mul_red.a_i(brdf);    mul_red.b_i(r_ks);                                            mul_red.p_o(r_o);
    mul_green.a_i(brdf);  mul_green.b_i(g_ks);                                          mul_green.p_o(g_o);
    mul_blue.a_i(brdf);   mul_blue.b_i(b_ks);                                           mul_blue.p_o(b_o);
    // clang-format on
  }

  /// Clock and control of the divider.
  template <class Divider>
  void pace(Divider& div) {
    div.clk(clk);
    div.rst_n(rst_n);
    div.load_i(first);
    div.step_i(step);
  }

  /// The ports with their numbers in the figure and what they are for.
  template <class Reader>
  static void pins(Reader& reader) {
    using d = iterative_device;
    reader.clock(&d::clk, {"clk", "", "clk", "clock"});
    reader.reset(&d::rst_n, {"rst_n", "", "rst_n", "synchronous, active low"});
    reader.data(&d::n_i, Figure::n_i, typename Formats::n{}, "n");
    reader.data(&d::cos_i, Figure::cos_i, typename Formats::cos_delta{}, "cos");
    reader.data(&d::r_i, Figure::r_i, colour{}, "r");
    reader.data(&d::g_i, Figure::g_i, colour{}, "g");
    reader.data(&d::b_i, Figure::b_i, colour{}, "b");
    reader.start(&d::start_i, {"start_i", "", "start", "takes the inputs while ready_o is one"});
    reader.ready(&d::ready_o, {"ready_o", "", "ready", "start_i takes the inputs"});
    reader.inner_result(&d::brdf, {"brdf", "", "brdf", "BRDF"}, typename Formats::brdf{}, "brdf");
    reader.result(&d::r_o, Figure::r_o, typename Formats::out{}, "red");
    reader.result(&d::g_o, Figure::g_o, typename Formats::out{}, "green");
    reader.result(&d::b_o, Figure::b_o, typename Formats::out{}, "blue");
    reader.valid(&d::valid_o, {"valid_o", "", "valid", "a result is at the outputs"});
    reader.settles_after(digits + 1);
  }

  /// The parts list, for the same readers.
  auto blocks() const { return std::tie(control, rg_n, rg_cos, rg3, rg4, rg5, mul_red, mul_green, mul_blue); }
};

}  // namespace blysk
