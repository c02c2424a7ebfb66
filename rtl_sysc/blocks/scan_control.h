// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/clocked.h"
#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Control of a device that takes a scan line into registers, then draws it: idle, one cycle for the first value, one for
/// each pixel.
///
/// Instances  control of UA 71489, whose inputs are reset, start and the counter's carry.
/// Ports      load_o = start_i while idle; first_o is one in the cycle that prepares the first pixel; step_o in that one and
///            while a pixel is at the outputs; draw_o while a pixel is at the outputs; ready_o while idle.
///            carry_i ends the line with the pixel that is at the outputs.
/// Timing     load_o follows start_i; the others change after the rising edge of clk.   Reset  idle.
struct scan_control : sc_core::sc_module {
  using state = uq<2, 0>;  // 0: idle, 1: first, 2: draw

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(start_i);
  sc_core::sc_in<bool> SC_NAMED(carry_i);
  sc_core::sc_out<bool> SC_NAMED(load_o);
  sc_core::sc_out<bool> SC_NAMED(first_o);
  sc_core::sc_out<bool> SC_NAMED(step_o);
  sc_core::sc_out<bool> SC_NAMED(draw_o);
  sc_core::sc_out<bool> SC_NAMED(ready_o);

  SC_CTOR(scan_control) {
    BLYSK_CLOCKED(go_on);
    SC_METHOD(decode);
    sensitive << start_i << now;
  }

  template <class T>
  static constexpr T is_first(T state) {
    return static_cast<T>(state == static_cast<T>(1));
  }
  template <class T>
  static constexpr T draws(T state) {
    return static_cast<T>(state == static_cast<T>(2));
  }
  template <class T>
  static constexpr T steps(T state) {
    return static_cast<T>(is_first(state) || draws(state));
  }
  /// The state after a clock edge.
  template <class T>
  static constexpr T next(T start, T ends, T state) {
    using law::select;
    const T idle = static_cast<T>(0);
    const T first = static_cast<T>(1);
    const T draw = static_cast<T>(2);
    return select(law::starts(start, state), first,
                  select(is_first(state), draw, select(draws(state) && !ends, draw, idle)));
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("scan_control", "Control: takes a line, prepares its first pixel, draws until carry_i.");
    const auto start = reader.read(start_i);
    const auto ends = reader.read(carry_i);
    const auto held = reader.read(now);
    reader.reg(clk, rst_n, reader.constant(1), next(start, ends, held), now, state{});
    reader.drive(load_o, law::starts(start, held));
    reader.drive(first_o, is_first(held));
    reader.drive(step_o, steps(held));
    reader.drive(draw_o, draws(held));
    reader.drive(ready_o, law::is_idle(held));
  }

 private:
  BLYSK_CLOCKED_BODY(go_on)
  void go_on() {
    if (!rst_n.read()) {
      now.write(0);
    } else {
      now.write(next<std::int64_t>(start_i.read() ? 1 : 0, carry_i.read() ? 1 : 0, now.read().to_int64()));
    }
  }
  void decode() {
    const std::int64_t held = now.read().to_int64();
    load_o.write(law::starts<std::int64_t>(start_i.read() ? 1 : 0, held) != 0);
    first_o.write(is_first(held) != 0);
    step_o.write(steps(held) != 0);
    draw_o.write(draws(held) != 0);
    ready_o.write(law::is_idle(held) != 0);
  }

  sc_core::sc_signal<state::raw_t> SC_NAMED(now);
};

}  // namespace blysk
