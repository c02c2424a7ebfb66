// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/buffer.h"
#include "rtl_sysc/blocks/mul.h"
#include "rtl_sysc/blocks/reg_level.h"
#include "rtl_sysc/blocks/reg_trailing.h"
#include "rtl_sysc/formats.h"
#include "rtl_sysc/pin.h"

#include <cstddef>
#include <tuple>

namespace blysk {

/// Numbers of [P] (patent UA 60553) fig. 1, which UA 22802 shares: names of the instances, and the pins.
struct patent_figure {
  static constexpr const char* rg_n = "rg1";
  static constexpr const char* rg_cos = "rg2";
  static constexpr const char* mul_red = "mul12";
  static constexpr const char* mul_green = "mul13";
  static constexpr const char* mul_blue = "mul14";
  static constexpr const char* buf_valid = "buf29";

  static constexpr pin n_i{"n_i", "16", "n16", "n"};
  static constexpr pin n_we_i{"n_we_i", "15", "strobe15", "write rg1"};
  static constexpr pin cos_i{"cos_i", "18", "cos18", "cos(delta), 0..1"};
  static constexpr pin cos_we_i{"cos_we_i", "17", "strobe17", "write rg2, by its trailing edge"};
  static constexpr pin r_i{"r_i", "19", "red19", "R k_s"};
  static constexpr pin r_we_i{"r_we_i", "20", "strobe20", "write rg3"};
  static constexpr pin g_i{"g_i", "21", "green21", "G k_s"};
  static constexpr pin g_we_i{"g_we_i", "22", "strobe22", "write rg4"};
  static constexpr pin b_i{"b_i", "23", "blue23", "B k_s"};
  static constexpr pin b_we_i{"b_we_i", "24", "strobe24", "write rg5"};
  static constexpr pin r_o{"r_o", "25", "out25_red", "red"};
  static constexpr pin g_o{"g_o", "26", "out26_green", "green"};
  static constexpr pin b_o{"b_o", "27", "out27_blue", "blue"};
  static constexpr pin valid_o{"valid_o", "29", "valid29", "25..27 are valid at its leading edge"};
};

/// The channel of a net that carries a T: a signal, or Formats::channel<T> where a bench has put its own channels, with the
/// interfaces of a signal, in the place of the nets.
template <class Formats, class T>
struct channel_of {
  using type = sc_core::sc_signal<T>;
};
template <class Formats, class T>
requires requires {
  typename Formats::template channel<T>;
}
struct channel_of<Formats, T> {
  using type = typename Formats::template channel<T>;
};

/// Where a pipelined device has registers, the others have a wire; see pipelined_device.
struct no_stage {
  const char* pipe_name = "";
  const char* net_name = "";
  int from = 0;
  int to = 0;
  std::nullptr_t registers = nullptr;
};

/// What the devices that shade a point have in common: the five registers, the three colour multipliers and the strobes
/// of [P] fig. 1 and fig. 3, which UA 22802 and [T] fig. 3.1 share.
///   (r_o, g_o, b_o) = brdf * (R, G, B) k_s
/// A device derives from it and drives the net brdf from the nets n and cos_delta.
///
/// Formats  Formats::n, ::cos_delta, ::brdf, ::out; colours in are UQ8.0.
/// Timing   [P] fig. 3: the register of cos loads on the trailing edge of its strobe, the others while their strobe is at
///          one, all sampled on clk. The outputs settle within one path from that register through the colour multipliers
///          and are valid at the next leading edge of valid_o.
/// Reset    rst_n low at a rising edge of clk: all registers 0.
/// \tparam Figure  names and numbers of the figure, as patent_figure has them
template <class Formats, class Figure = patent_figure>
struct specular_device : sc_core::sc_module {
  template <class Q>
  using in = sc_core::sc_in<typename Q::raw_t>;
  template <class Q>
  using out = sc_core::sc_out<typename Q::raw_t>;
  template <class Q>
  using net = typename channel_of<Formats, typename Q::raw_t>::type;
  template <class Q>
  using staged = no_stage;
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

  reg_level<typename Formats::n> rg_n;
  reg_trailing<typename Formats::cos_delta> rg_cos;
  reg_level<colour> SC_NAMED(rg3);
  reg_level<colour> SC_NAMED(rg4);
  reg_level<colour> SC_NAMED(rg5);
  mul_colour mul_red;
  mul_colour mul_green;
  mul_colour mul_blue;
  buffer buf_valid;

  net<typename Formats::n> SC_NAMED(n);
  net<typename Formats::cos_delta> SC_NAMED(cos_delta);
  net<colour> SC_NAMED(r_ks);
  net<colour> SC_NAMED(g_ks);
  net<colour> SC_NAMED(b_ks);
  net<typename Formats::brdf> SC_NAMED(brdf);
  no_stage brdf_first{};

  explicit specular_device(const sc_core::sc_module_name& name)
      : sc_core::sc_module(name),
        rg_n(Figure::rg_n),
        rg_cos(Figure::rg_cos),
        mul_red(Figure::mul_red),
        mul_green(Figure::mul_green),
        mul_blue(Figure::mul_blue),
        buf_valid(Figure::buf_valid) {
    // clang-format off
    rg_n.clk(clk);          rg_n.rst_n(rst_n);    rg_n.d_i(n_i);      rg_n.we_i(n_we_i);      rg_n.q_o(n);
    rg_cos.clk(clk);        rg_cos.rst_n(rst_n);  rg_cos.d_i(cos_i);  rg_cos.we_i(cos_we_i);  rg_cos.q_o(cos_delta);
    rg3.clk(clk);           rg3.rst_n(rst_n);     rg3.d_i(r_i);       rg3.we_i(r_we_i);       rg3.q_o(r_ks);
    rg4.clk(clk);           rg4.rst_n(rst_n);     rg4.d_i(g_i);       rg4.we_i(g_we_i);       rg4.q_o(g_ks);
    rg5.clk(clk);           rg5.rst_n(rst_n);     rg5.d_i(b_i);       rg5.we_i(b_we_i);       rg5.q_o(b_ks);
    mul_red.a_i(brdf);      mul_red.b_i(r_ks);                                                mul_red.p_o(r_o);
    mul_green.a_i(brdf);    mul_green.b_i(g_ks);                                              mul_green.p_o(g_o);
    mul_blue.a_i(brdf);     mul_blue.b_i(b_ks);                                               mul_blue.p_o(b_o);
    buf_valid.a_i(cos_we_i);                                                                  buf_valid.y_o(valid_o);
    // clang-format on
  }

  /// As iterative_device has them: a divider is the row of subtractors itself, which needs no clock.
  template <class Row>
  using divider = Row;
  template <class Divider>
  static void pace(Divider&) {}

  /// As pipelined_device has them: nets are seen as they are driven.
  template <class Net>
  static Net& at(no_stage&, Net& driven) {
    return driven;
  }
  template <class Net>
  static Net& before(no_stage&, Net& read) {
    return read;
  }

  /// The ports with their numbers in the figure and what they are for.
  template <class Reader>
  static void pins(Reader& reader) {
    using d = specular_device;
    reader.clock(&d::clk, {"clk", "", "clk", "samples the write strobes"});
    reader.reset(&d::rst_n, {"rst_n", "", "rst_n", "synchronous, active low"});
    reader.data(&d::n_i, Figure::n_i, typename Formats::n{}, "n");
    reader.strobe(&d::n_we_i, Figure::n_we_i, "n_i", write_edge::level);
    reader.data(&d::cos_i, Figure::cos_i, typename Formats::cos_delta{}, "cos");
    reader.strobe(&d::cos_we_i, Figure::cos_we_i, "cos_i", write_edge::trailing);
    reader.data(&d::r_i, Figure::r_i, colour{}, "r");
    reader.strobe(&d::r_we_i, Figure::r_we_i, "r_i", write_edge::level);
    reader.data(&d::g_i, Figure::g_i, colour{}, "g");
    reader.strobe(&d::g_we_i, Figure::g_we_i, "g_i", write_edge::level);
    reader.data(&d::b_i, Figure::b_i, colour{}, "b");
    reader.strobe(&d::b_we_i, Figure::b_we_i, "b_i", write_edge::level);
    reader.inner_result(&d::brdf, {"brdf", "", "brdf", "BRDF"}, typename Formats::brdf{}, "brdf");
    reader.result(&d::r_o, Figure::r_o, typename Formats::out{}, "red");
    reader.result(&d::g_o, Figure::g_o, typename Formats::out{}, "green");
    reader.result(&d::b_o, Figure::b_o, typename Formats::out{}, "blue");
    reader.valid(&d::valid_o, Figure::valid_o);
  }

  /// The parts list, for the same readers.
  auto blocks() const {
    return std::tie(rg_n, rg_cos, rg3, rg4, rg5, mul_red, mul_green, mul_blue, buf_valid);
  }
};

}  // namespace blysk
