// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/buffer.h"
#include "rtl_sysc/blocks/mul.h"
#include "rtl_sysc/blocks/reg_level.h"
#include "rtl_sysc/blocks/reg_trailing.h"
#include "rtl_sysc/formats.h"
#include "rtl_sysc/pin.h"

#include <tuple>

namespace blysk {

/// What the devices that shade a point have in common: the five registers, the three colour multipliers and the strobes
/// of [P] (patent UA 60553) fig. 1 and fig. 3, which UA 22802 and [T] fig. 3.1 share. Numbers are those of [P] fig. 1.
///   (r_o, g_o, b_o) = brdf * (R, G, B) k_s
/// A device derives from it and drives the net brdf from the nets n and cos_delta.
///
/// Formats  Formats::n, ::cos_delta, ::brdf, ::out; colours in are UQ8.0.
/// Timing   [P] fig. 3: rg2 loads on the trailing edge of 17, the other registers while their strobe is at one,
///          all sampled on clk. 25..27 settle within one path rg2 -> mul12..14 and are valid at the next leading
///          edge of 29.
/// Reset    rst_n low at a rising edge of clk: all registers 0.
template <class Formats>
struct specular_device : sc_core::sc_module {
  template <class Q>
  using in = sc_core::sc_in<typename Q::raw_t>;
  template <class Q>
  using out = sc_core::sc_out<typename Q::raw_t>;
  template <class Q>
  using net = sc_core::sc_signal<typename Q::raw_t>;
  using mul_colour = mul<typename Formats::brdf, colour, typename Formats::out>;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  in<typename Formats::n> SC_NAMED(n_i);
  sc_core::sc_in<bool> SC_NAMED(n_we_i);
  in<typename Formats::cos_delta> SC_NAMED(cos_i);
  sc_core::sc_in<bool> SC_NAMED(cos_we_i);
  in<colour> SC_NAMED(r_i);
  sc_core::sc_in<bool> SC_NAMED(r_we_i);
  in<colour> SC_NAMED(g_i);
  sc_core::sc_in<bool> SC_NAMED(g_we_i);
  in<colour> SC_NAMED(b_i);
  sc_core::sc_in<bool> SC_NAMED(b_we_i);
  out<typename Formats::out> SC_NAMED(r_o);
  out<typename Formats::out> SC_NAMED(g_o);
  out<typename Formats::out> SC_NAMED(b_o);
  sc_core::sc_out<bool> SC_NAMED(valid_o);

  reg_level<typename Formats::n> SC_NAMED(rg1);
  reg_trailing<typename Formats::cos_delta> SC_NAMED(rg2);
  reg_level<colour> SC_NAMED(rg3);
  reg_level<colour> SC_NAMED(rg4);
  reg_level<colour> SC_NAMED(rg5);
  mul_colour SC_NAMED(mul12);
  mul_colour SC_NAMED(mul13);
  mul_colour SC_NAMED(mul14);
  buffer SC_NAMED(buf29);

  net<typename Formats::n> SC_NAMED(n);
  net<typename Formats::cos_delta> SC_NAMED(cos_delta);
  net<colour> SC_NAMED(r_ks);
  net<colour> SC_NAMED(g_ks);
  net<colour> SC_NAMED(b_ks);
  net<typename Formats::brdf> SC_NAMED(brdf);

  explicit specular_device(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {
    // clang-format off
    rg1.clk(clk);      rg1.rst_n(rst_n);  rg1.d_i(n_i);    rg1.we_i(n_we_i);    rg1.q_o(n);
    rg2.clk(clk);      rg2.rst_n(rst_n);  rg2.d_i(cos_i);  rg2.we_i(cos_we_i);  rg2.q_o(cos_delta);
    rg3.clk(clk);      rg3.rst_n(rst_n);  rg3.d_i(r_i);    rg3.we_i(r_we_i);    rg3.q_o(r_ks);
    rg4.clk(clk);      rg4.rst_n(rst_n);  rg4.d_i(g_i);    rg4.we_i(g_we_i);    rg4.q_o(g_ks);
    rg5.clk(clk);      rg5.rst_n(rst_n);  rg5.d_i(b_i);    rg5.we_i(b_we_i);    rg5.q_o(b_ks);
    mul12.a_i(brdf);   mul12.b_i(r_ks);                                         mul12.p_o(r_o);
    mul13.a_i(brdf);   mul13.b_i(g_ks);                                         mul13.p_o(g_o);
    mul14.a_i(brdf);   mul14.b_i(b_ks);                                         mul14.p_o(b_o);
    buf29.a_i(cos_we_i);                                                        buf29.y_o(valid_o);
    // clang-format on
  }

  /// The ports with their numbers in the figure and what they are for.
  template <class Reader>
  static void pins(Reader& reader) {
    using d = specular_device;
    reader.clock(&d::clk, {"clk", "", "clk", "samples the write strobes"});
    reader.reset(&d::rst_n, {"rst_n", "", "rst_n", "synchronous, active low"});
    reader.data(&d::n_i, {"n_i", "16", "n16", "n"}, typename Formats::n{}, "n");
    reader.strobe(&d::n_we_i, {"n_we_i", "15", "strobe15", "write rg1"}, "n_i", write_edge::level);
    reader.data(&d::cos_i, {"cos_i", "18", "cos18", "cos(delta), 0..1"}, typename Formats::cos_delta{},
                "cos");
    reader.strobe(&d::cos_we_i, {"cos_we_i", "17", "strobe17", "write rg2, by its trailing edge"}, "cos_i",
                  write_edge::trailing);
    reader.data(&d::r_i, {"r_i", "19", "red19", "R k_s"}, colour{}, "r");
    reader.strobe(&d::r_we_i, {"r_we_i", "20", "strobe20", "write rg3"}, "r_i", write_edge::level);
    reader.data(&d::g_i, {"g_i", "21", "green21", "G k_s"}, colour{}, "g");
    reader.strobe(&d::g_we_i, {"g_we_i", "22", "strobe22", "write rg4"}, "g_i", write_edge::level);
    reader.data(&d::b_i, {"b_i", "23", "blue23", "B k_s"}, colour{}, "b");
    reader.strobe(&d::b_we_i, {"b_we_i", "24", "strobe24", "write rg5"}, "b_i", write_edge::level);
    reader.inner_result(&d::brdf, {"brdf", "", "brdf", "BRDF"}, typename Formats::brdf{}, "brdf");
    reader.result(&d::r_o, {"r_o", "25", "out25_red", "red"}, typename Formats::out{}, "red");
    reader.result(&d::g_o, {"g_o", "26", "out26_green", "green"}, typename Formats::out{}, "green");
    reader.result(&d::b_o, {"b_o", "27", "out27_blue", "blue"}, typename Formats::out{}, "blue");
    reader.valid(&d::valid_o, {"valid_o", "29", "valid29", "25..27 are valid at its leading edge"});
  }

  /// The parts list, for the same readers.
  auto blocks() const { return std::tie(rg1, rg2, rg3, rg4, rg5, mul12, mul13, mul14, buf29); }
};

}  // namespace blysk
