// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/devices/restoring_divider/formats.h"
#include "rtl_sysc/pin.h"

#include <tuple>

namespace blysk {

/// Restoring division of a difference by a run length, a digit of the quotient each clock cycle: what [T] fig. 2.13 is
/// compared with. Ports and columns are those of shift_divider.
///   increment_o = difference_i / length_i, rounded towards 0
///
/// Formats  Formats: a restoring_divider_formats.
/// Timing   takes both inputs at a rising edge of clk that sees start_i and ready_o at one; increment_o is valid in the one
///          cycle in which valid_o is at one, increment_bits + 9 rising edges later, when the next inputs can be taken.
/// Reset    rst_n low at a rising edge of clk: ready, all registers 0.
template <class Formats>
struct restoring_divider : sc_core::sc_module {
  template <class Q>
  using net = sc_core::sc_signal<typename Q::raw_t>;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<typename Formats::difference::raw_t> SC_NAMED(difference_i);
  sc_core::sc_in<typename Formats::length::raw_t> SC_NAMED(length_i);
  sc_core::sc_in<bool> SC_NAMED(start_i);
  sc_core::sc_out<bool> SC_NAMED(ready_o);
  sc_core::sc_out<typename Formats::increment::raw_t> SC_NAMED(increment_o);
  sc_core::sc_out<bool> SC_NAMED(valid_o);

  typename Formats::control SC_NAMED(control);
  typename Formats::sign_of SC_NAMED(sign_of);
  pipe<single_bit> rg_sign;
  typename Formats::mag_difference SC_NAMED(mag_difference);
  typename Formats::fraction_of SC_NAMED(fraction_of);
  typename Formats::div SC_NAMED(div);
  typename Formats::whole_of SC_NAMED(whole_of);
  typename Formats::sign_quotient SC_NAMED(sign_quotient);

  sc_core::sc_signal<bool> SC_NAMED(load);
  sc_core::sc_signal<bool> SC_NAMED(step);
  sc_core::sc_signal<bool> SC_NAMED(is_negative);
  sc_core::sc_signal<bool> SC_NAMED(was_negative);
  net<typename Formats::size> SC_NAMED(size);
  net<typename Formats::dividend> SC_NAMED(dividend);
  net<typename Formats::quotient> SC_NAMED(quotient);
  net<typename Formats::increment_size> SC_NAMED(increment_size);

  explicit restoring_divider(const sc_core::sc_module_name& name)
      : sc_core::sc_module(name), rg_sign("rg_sign", 1) {
    static_assert(Formats::no_overflow());
    // clang-format off
    control.clk(clk);    control.rst_n(rst_n);    control.start_i(start_i);
    control.load_o(load);  control.step_o(step);  control.ready_o(ready_o);  control.done_o(valid_o);
    sign_of.a_i(difference_i);                                               sign_of.negative_o(is_negative);
    rg_sign.clk(clk);    rg_sign.rst_n(rst_n);    rg_sign.go_i(load);
    rg_sign.d_i(is_negative);                                                rg_sign.q_o(was_negative);
    mag_difference.a_i(difference_i);                                        mag_difference.y_o(size);
    fraction_of.a_i(size);                                                   fraction_of.y_o(dividend);
    div.clk(clk);        div.rst_n(rst_n);        div.load_i(load);          div.step_i(step);
    div.a_i(dividend);   div.b_i(length_i);                                  div.q_o(quotient);
    whole_of.a_i(quotient);                                                  whole_of.y_o(increment_size);
    sign_quotient.a_i(increment_size);  sign_quotient.negative_i(was_negative);  sign_quotient.y_o(increment_o);
    // clang-format on
  }

  /// The ports and what they are for; no seed has a figure of it.
  template <class Reader>
  static void pins(Reader& reader) {
    using d = restoring_divider;
    reader.clock(&d::clk, {"clk", "", "clk", "clock"});
    reader.reset(&d::rst_n, {"rst_n", "", "rst_n", "synchronous, active low"});
    reader.data(&d::difference_i,
                {"difference_i", "", "difference", "difference of the intensities at the ends"},
                typename Formats::difference{}, "difference");
    reader.data(&d::length_i, {"length_i", "", "length", "pixels between the ends"},
                typename Formats::length{}, "length");
    reader.start(&d::start_i, {"start_i", "", "start", "takes the inputs while ready_o is one"});
    reader.ready(&d::ready_o, {"ready_o", "", "ready", "start_i takes the inputs"});
    reader.result(&d::increment_o, {"increment_o", "", "increment", "difference / length"},
                  typename Formats::increment{}, "increment");
    reader.valid(&d::valid_o, {"valid_o", "", "valid", "increment_o is valid"});
  }

  /// The parts list, for the same readers.
  auto blocks() const {
    return std::tie(control, sign_of, rg_sign, mag_difference, fraction_of, div, whole_of, sign_quotient);
  }
};

}  // namespace blysk
