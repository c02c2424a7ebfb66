// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/devices/arccos/formats.h"
#include "rtl_sysc/pin.h"

#include <tuple>

namespace blysk {

/// Arc cosine, what a cosine has to go through before UA 71489 can take it.
///   angle_o = sqrt(v) (arccos(1 - v) / sqrt(v)),   v = 1 - cos
/// The root is found digit by digit; the ratio is smooth, sqrt 2 to pi/2, and comes from a table by straight lines.
///
/// Formats  Formats: an arccos_formats.
/// Timing   takes cos_i at a rising edge of clk that sees start_i and ready_o at one; angle_o is valid in the one cycle in
///          which valid_o is at one, root_bits + 2 rising edges later, when the next cosine can be taken.
/// Error    below 1 ulp of angle_o; 0 for cos = 1.
/// Reset    rst_n low at a rising edge of clk: ready, all registers 0.
template <class Formats>
struct arccos : sc_core::sc_module {
  template <class Q>
  using net = sc_core::sc_signal<typename Q::raw_t>;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<typename Formats::cos_delta::raw_t> SC_NAMED(cos_i);
  sc_core::sc_in<bool> SC_NAMED(start_i);
  sc_core::sc_out<bool> SC_NAMED(ready_o);
  sc_core::sc_out<typename Formats::angle::raw_t> SC_NAMED(angle_o);
  sc_core::sc_out<bool> SC_NAMED(valid_o);

  typename Formats::control SC_NAMED(control);
  typename Formats::sub SC_NAMED(sub);
  reg_level<typename Formats::versine> SC_NAMED(rg_versine);
  typename Formats::root SC_NAMED(root);
  typename Formats::line SC_NAMED(line);
  typename Formats::mul_angle SC_NAMED(mul_angle);

  sc_core::sc_signal<bool> SC_NAMED(load);
  sc_core::sc_signal<bool> SC_NAMED(step);
  net<typename Formats::versine> SC_NAMED(versine_in);
  net<typename Formats::versine> SC_NAMED(versine);
  net<typename Formats::root_of_versine> SC_NAMED(root_of_versine);
  net<typename Formats::ratio> SC_NAMED(ratio);

  SC_CTOR(arccos) {
    static_assert(Formats::no_overflow());
    // clang-format off
    control.clk(clk);     control.rst_n(rst_n);     control.start_i(start_i);
    control.load_o(load);  control.step_o(step);  control.ready_o(ready_o);  control.done_o(valid_o);
    sub.a_i(cos_i);                                                           sub.y_o(versine_in);
    rg_versine.clk(clk);  rg_versine.rst_n(rst_n);
    rg_versine.d_i(versine_in);  rg_versine.we_i(load);                       rg_versine.q_o(versine);
    root.clk(clk);        root.rst_n(rst_n);        root.load_i(load);        root.step_i(step);
    root.d_i(versine_in);                                                     root.root_o(root_of_versine);
    line.a_i(versine);                                                        line.y_o(ratio);
    mul_angle.a_i(root_of_versine);  mul_angle.b_i(ratio);                    mul_angle.p_o(angle_o);
    // clang-format on
  }

  /// The ports and what they are for; no seed has a figure of it.
  template <class Reader>
  static void pins(Reader& reader) {
    using d = arccos;
    reader.clock(&d::clk, {"clk", "", "clk", "clock"});
    reader.reset(&d::rst_n, {"rst_n", "", "rst_n", "synchronous, active low"});
    reader.data(&d::cos_i, {"cos_i", "", "cos", "cosine, 0..1"}, typename Formats::cos_delta{}, "cos");
    reader.start(&d::start_i, {"start_i", "", "start", "takes the cosine while ready_o is one"});
    reader.ready(&d::ready_o, {"ready_o", "", "ready", "start_i takes the cosine"});
    reader.result(&d::angle_o, {"angle_o", "", "angle", "its angle, rad"}, typename Formats::angle{},
                  "angle");
    reader.valid(&d::valid_o, {"valid_o", "", "valid", "angle_o is valid"});
  }

  /// The parts list, for the same readers.
  auto blocks() const { return std::tie(control, sub, rg_versine, root, line, mul_angle); }
};

}  // namespace blysk
