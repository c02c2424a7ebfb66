// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/buffer.h"
#include "rtl_sysc/blocks/constant.h"
#include "rtl_sysc/blocks/reg_level.h"
#include "rtl_sysc/blocks/reg_trailing.h"
#include "rtl_sysc/formats.h"

#include <tuple>

namespace blysk {

/// Specular device of [P] (patent UA 60553) fig. 1; numbers are those of the figure.
///   (r_o, g_o, b_o) = brdf * (R, G, B) k_s,   brdf = a (c^2 - c) + c,   a = slope n + offset
/// Formats  F: a quadratic_formats of formats.h; colours in are UQ8.0, out are F::out.
/// Timing   [P] fig. 3: rg2 loads on the trailing edge of 17, the other registers while their strobe is at one,
///          all sampled on clk. 25..27 settle within one path rg2 -> mul12..14 and are valid at the next leading
///          edge of 29.
/// Reset    rst_n low at a rising edge of clk: all registers 0, hence all outputs 0.
template <class F>
struct quadratic : sc_core::sc_module {
  template <class Q>
  using in = sc_core::sc_in<typename Q::raw_t>;
  template <class Q>
  using out = sc_core::sc_out<typename Q::raw_t>;
  template <class Q>
  using net = sc_core::sc_signal<typename Q::raw_t>;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  in<typename F::n> SC_NAMED(n_i);
  sc_core::sc_in<bool> SC_NAMED(n_we_i);
  in<typename F::cos_delta> SC_NAMED(cos_i);
  sc_core::sc_in<bool> SC_NAMED(cos_we_i);
  in<colour> SC_NAMED(r_i);
  sc_core::sc_in<bool> SC_NAMED(r_we_i);
  in<colour> SC_NAMED(g_i);
  sc_core::sc_in<bool> SC_NAMED(g_we_i);
  in<colour> SC_NAMED(b_i);
  sc_core::sc_in<bool> SC_NAMED(b_we_i);
  out<typename F::out> SC_NAMED(r_o);
  out<typename F::out> SC_NAMED(g_o);
  out<typename F::out> SC_NAMED(b_o);
  sc_core::sc_out<bool> SC_NAMED(valid_o);

  reg_level<typename F::n> SC_NAMED(rg1);
  reg_trailing<typename F::cos_delta> SC_NAMED(rg2);
  reg_level<colour> SC_NAMED(rg3);
  reg_level<colour> SC_NAMED(rg4);
  reg_level<colour> SC_NAMED(rg5);
  constant<typename F::slope> node31;
  constant<typename F::offset> node32;
  constant<carry> carry28;
  constant<carry> carry30;
  typename F::mul6 SC_NAMED(mul6);
  typename F::add15 SC_NAMED(add15);
  typename F::mul7 SC_NAMED(mul7);
  typename F::inv8 SC_NAMED(inv8);
  typename F::add9 SC_NAMED(add9);
  typename F::mul10 SC_NAMED(mul10);
  typename F::add11 SC_NAMED(add11);
  typename F::quant11 SC_NAMED(quant11);
  typename F::mul_colour SC_NAMED(mul12);
  typename F::mul_colour SC_NAMED(mul13);
  typename F::mul_colour SC_NAMED(mul14);
  buffer SC_NAMED(buf29);

  net<typename F::n> SC_NAMED(n);
  net<typename F::cos_delta> SC_NAMED(cos_delta);
  net<colour> SC_NAMED(r_ks);
  net<colour> SC_NAMED(g_ks);
  net<colour> SC_NAMED(b_ks);
  net<typename F::slope> SC_NAMED(slope);
  net<typename F::offset> SC_NAMED(offset);
  net<carry> SC_NAMED(carry28_in);
  net<carry> SC_NAMED(carry30_in);
  net<typename F::slope_n> SC_NAMED(slope_n);
  net<typename F::a> SC_NAMED(a);
  net<typename F::cos2> SC_NAMED(cos2);
  net<typename F::cos_inv> SC_NAMED(cos_inv);
  net<typename F::diff> SC_NAMED(cos2_minus_cos);
  net<typename F::a_diff> SC_NAMED(a_times_diff);
  net<typename F::parabola> SC_NAMED(parabola);
  net<typename F::brdf> SC_NAMED(brdf);

  quadratic(const sc_core::sc_module_name& name, const wired_constants& wired)
      : sc_core::sc_module(name),
        node31("node31", wired.slope),
        node32("node32", wired.offset),
        carry28("carry28", 1),
        carry30("carry30", 0) {
    static_assert(F::no_overflow());
    // clang-format off
    rg1.clk(clk);   rg1.rst_n(rst_n);  rg1.d_i(n_i);      rg1.we_i(n_we_i);      rg1.q_o(n);
    rg2.clk(clk);   rg2.rst_n(rst_n);  rg2.d_i(cos_i);    rg2.we_i(cos_we_i);    rg2.q_o(cos_delta);
    rg3.clk(clk);   rg3.rst_n(rst_n);  rg3.d_i(r_i);      rg3.we_i(r_we_i);      rg3.q_o(r_ks);
    rg4.clk(clk);   rg4.rst_n(rst_n);  rg4.d_i(g_i);      rg4.we_i(g_we_i);      rg4.q_o(g_ks);
    rg5.clk(clk);   rg5.rst_n(rst_n);  rg5.d_i(b_i);      rg5.we_i(b_we_i);      rg5.q_o(b_ks);

    node31.y_o(slope);       node32.y_o(offset);
    carry28.y_o(carry28_in); carry30.y_o(carry30_in);

    mul6.a_i(n);             mul6.b_i(slope);                                      mul6.p_o(slope_n);
    add15.a_i(slope_n);      add15.b_i(offset);        add15.carry_i(carry30_in);  add15.s_o(a);
    mul7.a_i(cos_delta);     mul7.b_i(cos_delta);                                  mul7.p_o(cos2);
    inv8.a_i(cos_delta);                                                           inv8.y_o(cos_inv);
    add9.a_i(cos2);          add9.b_i(cos_inv);        add9.carry_i(carry28_in);   add9.s_o(cos2_minus_cos);
    mul10.a_i(a);            mul10.b_i(cos2_minus_cos);                            mul10.p_o(a_times_diff);
    add11.a_i(a_times_diff); add11.b_i(cos_delta);     add11.carry_i(carry30_in);  add11.s_o(parabola);
    quant11.a_i(parabola);                                                         quant11.y_o(brdf);
    mul12.a_i(brdf);         mul12.b_i(r_ks);                                      mul12.p_o(r_o);
    mul13.a_i(brdf);         mul13.b_i(g_ks);                                      mul13.p_o(g_o);
    mul14.a_i(brdf);         mul14.b_i(b_ks);                                      mul14.p_o(b_o);
    buf29.a_i(cos_we_i);                                                           buf29.y_o(valid_o);
    // clang-format on
  }

  /// The pins with their numbers in the figure, for readers of the structure (Verilog export).
  template <class Reader>
  void pins(Reader& reader) {
    reader.pin(clk, "samples the write strobes");
    reader.pin(rst_n, "synchronous");
    reader.pin(n_i, "16: n", typename F::n{});
    reader.pin(n_we_i, "15: write rg1");
    reader.pin(cos_i, "18: cos(delta), 0..1", typename F::cos_delta{});
    reader.pin(cos_we_i, "17: write rg2, by its trailing edge");
    reader.pin(r_i, "19: R k_s", colour{});
    reader.pin(r_we_i, "20: write rg3");
    reader.pin(g_i, "21: G k_s", colour{});
    reader.pin(g_we_i, "22: write rg4");
    reader.pin(b_i, "23: B k_s", colour{});
    reader.pin(b_we_i, "24: write rg5");
    reader.pin(r_o, "25: red", typename F::out{});
    reader.pin(g_o, "26: green", typename F::out{});
    reader.pin(b_o, "27: blue", typename F::out{});
    reader.pin(valid_o, "29: 25..27 are valid at its leading edge");
  }

  /// The parts list, for the same readers.
  auto blocks() const {
    return std::tie(rg1, rg2, rg3, rg4, rg5, node31, node32, carry28, carry30, mul6, add15, mul7, inv8, add9,
                    mul10, add11, quant11, mul12, mul13, mul14, buf29);
  }
};

}  // namespace blysk
