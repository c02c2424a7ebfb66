// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/clocked.h"
#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Control of a device that draws a scan line at once: counts the pixels that are left.
///
/// Instances  control of the interpolator by forward differences.
/// Ports      load_o = start_i while nothing is left; draw_o is one while a pixel is at the outputs, ready_o while none is.
/// Formats    length_i: Length unsigned; length_i + 1 pixels are drawn.
/// Timing     load_o follows start_i; the others change after the rising edge of clk.   Reset  ready.
template <class Length>
struct pixel_counter : sc_core::sc_module {
  using pixel_count = uq<Length::width + 1, 0>;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(start_i);
  sc_core::sc_in<typename Length::raw_t> SC_NAMED(length_i);
  sc_core::sc_out<bool> SC_NAMED(load_o);
  sc_core::sc_out<bool> SC_NAMED(draw_o);
  sc_core::sc_out<bool> SC_NAMED(ready_o);

  SC_CTOR(pixel_counter) {
    BLYSK_CLOCKED(count);
    SC_METHOD(decode);
    sensitive << start_i << left;
  }

  /// Pixels left after a clock edge.
  template <class T>
  static constexpr T next(T start, T length, T pixels) {
    return law::count_down(start, static_cast<T>(length + static_cast<T>(1)), pixels);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("pixel_counter", "Control: counts the length_i + 1 pixels of a scan line.");
    const auto start = reader.read(start_i);
    const auto pixels = reader.read(left);
    reader.reg(clk, rst_n, reader.constant(1), next(start, reader.read(length_i, Length{}), pixels), left,
               pixel_count{});
    reader.drive(load_o, law::starts(start, pixels));
    reader.drive(draw_o, law::is_active(pixels));
    reader.drive(ready_o, law::is_idle(pixels));
  }

 private:
  BLYSK_CLOCKED_BODY(count)
  void count() {
    if (!rst_n.read()) {
      left.write(0);
    } else {
      left.write(
          next<std::int64_t>(start_i.read() ? 1 : 0, length_i.read().to_int64(), left.read().to_int64()));
    }
  }
  void decode() {
    const std::int64_t pixels = left.read().to_int64();
    load_o.write(law::starts<std::int64_t>(start_i.read() ? 1 : 0, pixels) != 0);
    draw_o.write(law::is_active(pixels) != 0);
    ready_o.write(law::is_idle(pixels) != 0);
  }

  sc_core::sc_signal<typename pixel_count::raw_t> SC_NAMED(left);
};

}  // namespace blysk
