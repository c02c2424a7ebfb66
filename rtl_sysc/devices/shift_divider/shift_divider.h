// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/constant.h"
#include "rtl_sysc/devices/divider.h"
#include "rtl_sysc/devices/shift_divider/formats.h"

#include <tuple>

namespace blysk {

/// Division by a sum of shifts, [T] fig. 2.13: a shift register and an accumulating adder, which adds where the digit of
/// 1/k is one.
///   increment_o = difference_i * sum of i_j 2^-j,   1/length_i ~ sum of i_j 2^-j, j = 0..steps   [T] (2.18)
///
/// Formats  Formats: a shift_divider_formats.
/// Timing   takes both inputs at a rising edge of clk that sees start_i and ready_o at one; increment_o is valid in the one
///          cycle in which valid_o is at one, `steps` + 1 rising edges later, when the next inputs can be taken.
/// Reset    rst_n low at a rising edge of clk: ready, all registers 0.
template <class Formats>
struct shift_divider : divider<Formats> {
  using base = divider<Formats>;
  template <class Q>
  using net = typename base::template net<Q>;
  using base::clk, base::rst_n, base::difference_i, base::length_i, base::start_i;
  using base::ready_o, base::increment_o, base::valid_o;

  sequencer<Formats::steps> SC_NAMED(control);
  typename Formats::rom_digits rom_digits;
  typename Formats::rg_digits SC_NAMED(rg_digits);
  typename Formats::rg_shift SC_NAMED(rg_shift);
  constant<carry> ground;
  typename Formats::add_sum SC_NAMED(add_sum);
  typename Formats::rg_sum SC_NAMED(rg_sum);

  sc_core::sc_signal<bool> SC_NAMED(load);
  sc_core::sc_signal<bool> SC_NAMED(step);
  sc_core::sc_signal<bool> SC_NAMED(digit);
  net<typename Formats::digits> SC_NAMED(digits);
  net<typename Formats::shifted> SC_NAMED(shifted);
  net<carry> SC_NAMED(carry_in);
  net<typename Formats::increment> SC_NAMED(sum);

  explicit shift_divider(const sc_core::sc_module_name& name)
      : base(name), rom_digits("rom_digits", 0), ground("ground", 0) {
    static_assert(Formats::no_overflow());
    // clang-format off
    control.clk(clk);    control.rst_n(rst_n);    control.start_i(start_i);
    control.load_o(load);  control.step_o(step);  control.ready_o(ready_o);  control.done_o(valid_o);
    rom_digits.a_i(length_i);                                                              rom_digits.y_o(digits);
    rg_digits.clk(clk);  rg_digits.rst_n(rst_n);  rg_digits.load_i(load);  rg_digits.step_i(step);
    rg_digits.d_i(digits);                                                                 rg_digits.digit_o(digit);
    rg_shift.clk(clk);   rg_shift.rst_n(rst_n);   rg_shift.load_i(load);   rg_shift.step_i(step);
    rg_shift.d_i(difference_i);                                                            rg_shift.q_o(shifted);
    ground.y_o(carry_in);
    add_sum.a_i(increment_o);  add_sum.b_i(shifted);  add_sum.carry_i(carry_in);           add_sum.s_o(sum);
    rg_sum.clk(clk);     rg_sum.rst_n(rst_n);     rg_sum.load_i(load);     rg_sum.step_i(step);
    rg_sum.add_i(digit);  rg_sum.d_i(difference_i);  rg_sum.sum_i(sum);                    rg_sum.q_o(increment_o);
    // clang-format on
  }

  /// The parts list, for the same readers.
  auto blocks() const { return std::tie(control, rom_digits, rg_digits, rg_shift, ground, add_sum, rg_sum); }
};

}  // namespace blysk
