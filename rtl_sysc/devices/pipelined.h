// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/pipe.h"
#include "rtl_sysc/blocks/pipe_control.h"
#include "rtl_sysc/devices/specular.h"

#include <memory>

namespace blysk {

/// Where a pipeline has registers. The blocks of a device stand on levels, from 0 on; the cut k lies between the levels k - 1
/// and k.
struct pipeline_cuts {
  std::uint64_t places;  ///< bit k is one if the cut k has registers; bit 0 is 0

  /// Registers between two levels, each but the first of which lies behind a cut.
  constexpr int between(int from, int to) const {
    int count = 0;
    for (int cut = from + 1; cut <= to; ++cut) count += static_cast<int>((places >> cut) & 1);
    return count;
  }
};

/// A net as a level behind the one that drives it sees it.
template <class Q>
struct staged_net {
  using net = sc_core::sc_signal<typename Q::raw_t>;

  const char* pipe_name;
  const char* net_name;
  int from;  ///< level that drives it
  int to;    ///< level that reads it
  std::unique_ptr<pipe<Q>> registers = nullptr;
  std::unique_ptr<net> beside = nullptr;
};

/// What pipelined devices that shade a point have in common, in the place of specular_device: registers, colour multipliers
/// and outputs of [P] fig. 1, without its strobes.
///
/// Formats  Formats::n, ::cos_delta, ::brdf, ::out; colours in are UQ8.0.
/// Timing   takes its inputs at a rising edge of clk that sees start_i and ready_o at one; as many clock edges later as it has
///          stages, one more than cuts with registers, valid_o is one and the results are at the outputs. With stall_i at one
///          they stay there, and the registers keep what they hold; without a result at the outputs stall_i does nothing.
/// Reset    rst_n low at a rising edge of clk: all registers 0; what was under way is lost.
/// \tparam Figure  names and numbers of the figure, as patent_figure has them
/// \tparam Last    the level of the colour multipliers
template <class Formats, int Last, class Figure = patent_figure>
struct pipelined_device : sc_core::sc_module {
  template <class Q>
  using in = sc_core::sc_in<typename Q::raw_t>;
  template <class Q>
  using out = sc_core::sc_out<typename Q::raw_t>;
  template <class Q>
  using net = sc_core::sc_signal<typename Q::raw_t>;
  template <class Q>
  using staged = staged_net<Q>;
  using mul_colour = mul<typename Formats::brdf, colour, typename Formats::out>;
  static constexpr int levels = Last + 1;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  in<typename Formats::n> SC_NAMED(n_i);
  in<typename Formats::cos_delta> SC_NAMED(cos_i);
  in<colour> SC_NAMED(r_i);
  in<colour> SC_NAMED(g_i);
  in<colour> SC_NAMED(b_i);
  sc_core::sc_in<bool> SC_NAMED(start_i);
  sc_core::sc_in<bool> SC_NAMED(stall_i);
  sc_core::sc_out<bool> SC_NAMED(ready_o);
  out<typename Formats::out> SC_NAMED(r_o);
  out<typename Formats::out> SC_NAMED(g_o);
  out<typename Formats::out> SC_NAMED(b_o);
  sc_core::sc_out<bool> SC_NAMED(valid_o);

  pipe_control SC_NAMED(control);
  pipe<single_bit> pipe_valid;
  reg_level<typename Formats::n> rg_n;
  reg_level<typename Formats::cos_delta> rg_cos;
  reg_level<colour> SC_NAMED(rg3);
  reg_level<colour> SC_NAMED(rg4);
  reg_level<colour> SC_NAMED(rg5);
  mul_colour mul_red;
  mul_colour mul_green;
  mul_colour mul_blue;

  sc_core::sc_signal<bool> SC_NAMED(go);
  sc_core::sc_signal<bool> SC_NAMED(take);
  net<typename Formats::n> SC_NAMED(n);
  net<typename Formats::cos_delta> SC_NAMED(cos_delta);
  net<colour> SC_NAMED(r_ks);
  net<colour> SC_NAMED(g_ks);
  net<colour> SC_NAMED(b_ks);
  net<typename Formats::brdf> SC_NAMED(brdf);
  staged<colour> r_last{"pipe_r", "r_last", 0, Last};
  staged<colour> g_last{"pipe_g", "g_last", 0, Last};
  staged<colour> b_last{"pipe_b", "b_last", 0, Last};
  staged<typename Formats::brdf> brdf_first{"pipe_brdf", "brdf_first", Last - 1, Last};

  pipelined_device(const sc_core::sc_module_name& name, const pipeline_cuts& cuts)
      : sc_core::sc_module(name),
        pipe_valid("pipe_valid", 1 + cuts.between(0, Last)),
        rg_n(Figure::rg_n),
        rg_cos(Figure::rg_cos),
        mul_red(Figure::mul_red),
        mul_green(Figure::mul_green),
        mul_blue(Figure::mul_blue),
        cuts_(cuts) {
    // clang-format off
    control.start_i(start_i);  control.stall_i(stall_i);  control.valid_i(valid_o);
    control.go_o(go);          control.take_o(take);      control.ready_o(ready_o);
    pipe_valid.clk(clk);  pipe_valid.rst_n(rst_n);  pipe_valid.go_i(go);  pipe_valid.d_i(start_i);  pipe_valid.q_o(valid_o);
    rg_n.clk(clk);      rg_n.rst_n(rst_n);    rg_n.d_i(n_i);      rg_n.we_i(take);      rg_n.q_o(n);
    rg_cos.clk(clk);    rg_cos.rst_n(rst_n);  rg_cos.d_i(cos_i);  rg_cos.we_i(take);    rg_cos.q_o(cos_delta);
    rg3.clk(clk);       rg3.rst_n(rst_n);     rg3.d_i(r_i);       rg3.we_i(take);       rg3.q_o(r_ks);
    rg4.clk(clk);       rg4.rst_n(rst_n);     rg4.d_i(g_i);       rg4.we_i(take);       rg4.q_o(g_ks);
    rg5.clk(clk);       rg5.rst_n(rst_n);     rg5.d_i(b_i);       rg5.we_i(take);       rg5.q_o(b_ks);
    mul_red.a_i(brdf);    mul_red.b_i(at(r_last, r_ks));                                mul_red.p_o(r_o);
    mul_green.a_i(brdf);  mul_green.b_i(at(g_last, g_ks));                              mul_green.p_o(g_o);
    mul_blue.a_i(brdf);   mul_blue.b_i(at(b_last, b_ks));                               mul_blue.p_o(b_o);
    // clang-format on
  }

  /// The net that readers on the level of `place` are bound to, for the one that is driven on the level before.
  template <class Q>
  net<Q>& at(staged<Q>& place, net<Q>& driven) {
    if (!is_staged(place)) return driven;
    if (!place.registers) {
      make(place);
      connect(*place.registers, driven, *place.beside);
    }
    return *place.beside;
  }

  /// The net that a driver on the level before is bound to, for the one that the level of `place` reads.
  template <class Q>
  net<Q>& before(staged<Q>& place, net<Q>& read) {
    if (!is_staged(place)) return read;
    make(place);
    connect(*place.registers, *place.beside, read);
    return *place.beside;
  }

  /// The ports with their numbers in the figure and what they are for.
  template <class Reader>
  static void pins(Reader& reader) {
    using d = pipelined_device;
    reader.clock(&d::clk, {"clk", "", "clk", "clock"});
    reader.reset(&d::rst_n, {"rst_n", "", "rst_n", "synchronous, active low"});
    reader.data(&d::n_i, Figure::n_i, typename Formats::n{}, "n");
    reader.data(&d::cos_i, Figure::cos_i, typename Formats::cos_delta{}, "cos");
    reader.data(&d::r_i, Figure::r_i, colour{}, "r");
    reader.data(&d::g_i, Figure::g_i, colour{}, "g");
    reader.data(&d::b_i, Figure::b_i, colour{}, "b");
    reader.start(&d::start_i, {"start_i", "", "start", "takes the inputs while ready_o is one"});
    reader.control(&d::stall_i, {"stall_i", "", "stall", "keeps a result at the outputs"});
    reader.ready(&d::ready_o, {"ready_o", "", "ready", "start_i takes the inputs"});
    reader.inner_result(&d::brdf, {"brdf", "", "brdf", "BRDF"}, typename Formats::brdf{}, "brdf");
    reader.result(&d::r_o, Figure::r_o, typename Formats::out{}, "red");
    reader.result(&d::g_o, Figure::g_o, typename Formats::out{}, "green");
    reader.result(&d::b_o, Figure::b_o, typename Formats::out{}, "blue");
    reader.valid(&d::valid_o, {"valid_o", "", "valid", "a result is at the outputs"});
    reader.settles_after(levels);
  }

  /// The parts list, for the same readers.
  auto blocks() const {
    return std::tie(control, pipe_valid, rg_n, rg_cos, rg3, rg4, rg5, mul_red, mul_green, mul_blue,
                    r_last.registers, g_last.registers, b_last.registers, brdf_first.registers);
  }

 private:
  template <class Q>
  bool is_staged(const staged<Q>& place) const {
    return cuts_.between(place.from, place.to) > 0;
  }

  template <class Q>
  void make(staged<Q>& place) {
    place.registers = std::make_unique<pipe<Q>>(place.pipe_name, cuts_.between(place.from, place.to));
    place.beside = std::make_unique<net<Q>>(place.net_name);
  }

  template <class Q>
  void connect(pipe<Q>& registers, net<Q>& from, net<Q>& to) {
    registers.clk(clk);
    registers.rst_n(rst_n);
    registers.go_i(go);
    registers.d_i(from);
    registers.q_o(to);
  }

  const pipeline_cuts cuts_;
};

}  // namespace blysk
