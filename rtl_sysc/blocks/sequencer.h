// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/clocked.h"
#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Control of a device that takes a number of clock cycles for each result: a counter of the steps that are left.
///
/// Instances  control of the shift divider, [T] fig. 2.13.
/// Ports      load_o = start_i while no step is left; step_o is one while steps are left, ready_o while none is; done_o is one
///            in the cycle after the last step.
/// \tparam Steps  clock cycles from the one that loads to the result, 1 or more
/// Timing     load_o follows start_i; the others change after the rising edge of clk.   Reset  ready, no step left.
template <int Steps>
struct sequencer : sc_core::sc_module {
  using count = uq<7, 0>;
  static_assert(1 <= Steps && Steps <= count::max);

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(start_i);
  sc_core::sc_out<bool> SC_NAMED(load_o);
  sc_core::sc_out<bool> SC_NAMED(step_o);
  sc_core::sc_out<bool> SC_NAMED(ready_o);
  sc_core::sc_out<bool> SC_NAMED(done_o);

  SC_CTOR(sequencer) {
    BLYSK_CLOCKED(count_steps);
    SC_METHOD(decode);
    sensitive << start_i << left;
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("sequencer", "Control: counts the STEPS of an operation.");
    const auto start = reader.read(start_i);
    const auto steps = reader.parameter("STEPS", Steps, count{});
    const auto now = reader.read(left);
    reader.reg(clk, rst_n, reader.constant(1), law::count_down(start, steps, now), left, count{});
    reader.reg(clk, rst_n, reader.constant(1), law::is_last(now), done_o);
    reader.drive(load_o, law::starts(start, now));
    reader.drive(step_o, law::is_active(now));
    reader.drive(ready_o, law::is_idle(now));
  }

 private:
  BLYSK_CLOCKED_BODY(count_steps)
  void count_steps() {
    if (!rst_n.read()) {
      left.write(0);
      done_o.write(false);
    } else {
      const std::int64_t now = left.read().to_int64();
      left.write(law::count_down<std::int64_t>(start_i.read() ? 1 : 0, Steps, now));
      done_o.write(law::is_last(now) != 0);
    }
  }
  void decode() {
    const std::int64_t now = left.read().to_int64();
    load_o.write(law::starts<std::int64_t>(start_i.read() ? 1 : 0, now) != 0);
    step_o.write(law::is_active(now) != 0);
    ready_o.write(law::is_idle(now) != 0);
  }

  sc_core::sc_signal<typename count::raw_t> SC_NAMED(left);
};

}  // namespace blysk
