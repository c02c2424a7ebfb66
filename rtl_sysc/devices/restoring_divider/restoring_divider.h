// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/devices/divider.h"
#include "rtl_sysc/devices/restoring_divider/formats.h"

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
struct restoring_divider : divider<Formats> {
  using base = divider<Formats>;
  template <class Q>
  using net = typename base::template net<Q>;
  using base::clk, base::rst_n, base::difference_i, base::length_i, base::start_i;
  using base::ready_o, base::increment_o, base::valid_o;

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

  explicit restoring_divider(const sc_core::sc_module_name& name) : base(name), rg_sign("rg_sign", 1) {
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

  /// The parts list, for the same readers.
  auto blocks() const {
    return std::tie(control, sign_of, rg_sign, mag_difference, fraction_of, div, whole_of, sign_quotient);
  }
};

}  // namespace blysk
