// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/clocked.h"
#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Control of a device that draws a scan line: counts the steps that prepare it, then the pixels.
///
/// Instances  control of the Gouraud interpolator.
/// Ports      load_o = start_i while nothing is left; step_o is one during the steps, draw_o while a pixel is at the outputs,
///            ready_o while nothing is left.
/// Formats    length_i: Length unsigned; length_i + 1 pixels are drawn, both ends of the run.
/// \tparam Steps  clock cycles that prepare a line, 1 or more
/// Timing     load_o follows start_i; the others change after the rising edge of clk.   Reset  ready.
template <class Length, int Steps>
struct line_control : sc_core::sc_module {
  using count = uq<7, 0>;
  using pixel_count = uq<Length::width + 1, 0>;
  static_assert(1 <= Steps && Steps <= count::max);

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(start_i);
  sc_core::sc_in<typename Length::raw_t> SC_NAMED(length_i);
  sc_core::sc_out<bool> SC_NAMED(load_o);
  sc_core::sc_out<bool> SC_NAMED(step_o);
  sc_core::sc_out<bool> SC_NAMED(draw_o);
  sc_core::sc_out<bool> SC_NAMED(ready_o);

  SC_CTOR(line_control) {
    BLYSK_CLOCKED(count_down);
    SC_METHOD(decode);
    sensitive << start_i << steps_left << pixels_left;
  }

  /// Steps left after a clock edge; `pixels` is 0 when a line can start.
  template <class T>
  static constexpr T next_steps(T start, T number, T steps, T pixels) {
    using law::select;
    return select(law::starts(start, pixels), number, law::one_less(steps));
  }
  /// Pixels left: they wait for the steps.
  template <class T>
  static constexpr T next_pixels(T start, T length, T steps, T pixels) {
    using law::select;
    return select(law::starts(start, pixels), static_cast<T>(length + static_cast<T>(1)),
                  select(law::is_active(steps), pixels, law::one_less(pixels)));
  }
  template <class T>
  static constexpr T draws(T steps, T pixels) {
    return static_cast<T>(law::is_idle(steps) && law::is_active(pixels));
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("line_control",
                    "Control: counts the STEPS that prepare a scan line, then its length_i + 1 pixels.");
    const auto start = reader.read(start_i);
    const auto number = reader.parameter("STEPS", Steps, count{});
    const auto steps = reader.read(steps_left);
    const auto pixels = reader.read(pixels_left);
    const auto length = reader.read(length_i, Length{});
    const auto always = reader.constant(1);
    reader.reg(clk, rst_n, always, next_steps(start, number, steps, pixels), steps_left, count{});
    reader.reg(clk, rst_n, always, next_pixels(start, length, steps, pixels), pixels_left, pixel_count{});
    reader.drive(load_o, law::starts(start, pixels));
    reader.drive(step_o, law::is_active(steps));
    reader.drive(draw_o, draws(steps, pixels));
    reader.drive(ready_o, law::is_idle(pixels));
  }

 private:
  BLYSK_CLOCKED_BODY(count_down)
  void count_down() {
    if (!rst_n.read()) {
      steps_left.write(0);
      pixels_left.write(0);
    } else {
      const std::int64_t start = start_i.read() ? 1 : 0;
      const std::int64_t steps = steps_left.read().to_int64();
      const std::int64_t pixels = pixels_left.read().to_int64();
      steps_left.write(next_steps<std::int64_t>(start, Steps, steps, pixels));
      pixels_left.write(next_pixels<std::int64_t>(start, length_i.read().to_int64(), steps, pixels));
    }
  }
  void decode() {
    const std::int64_t steps = steps_left.read().to_int64();
    const std::int64_t pixels = pixels_left.read().to_int64();
    load_o.write(law::starts<std::int64_t>(start_i.read() ? 1 : 0, pixels) != 0);
    step_o.write(law::is_active(steps) != 0);
    draw_o.write(draws(steps, pixels) != 0);
    ready_o.write(law::is_idle(pixels) != 0);
  }

  sc_core::sc_signal<typename count::raw_t> SC_NAMED(steps_left);
  sc_core::sc_signal<typename pixel_count::raw_t> SC_NAMED(pixels_left);
};

}  // namespace blysk
