// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Control of a pipeline that stands still as a whole: while a result is at its end and nobody takes it.
///
/// Instances  control of the pipelined devices.
/// Ports      go_o = ready_o = !(stall_i and valid_i): all registers load; take_o = start_i and go_o: those at the inputs do.
/// Timing     combinational.   Error  none.
struct pipe_control : sc_core::sc_module {
  sc_core::sc_in<bool> SC_NAMED(start_i);
  sc_core::sc_in<bool> SC_NAMED(stall_i);
  sc_core::sc_in<bool> SC_NAMED(valid_i);
  sc_core::sc_out<bool> SC_NAMED(go_o);
  sc_core::sc_out<bool> SC_NAMED(take_o);
  sc_core::sc_out<bool> SC_NAMED(ready_o);

  SC_CTOR(pipe_control) {
    SC_METHOD(decode);
    sensitive << start_i << stall_i << valid_i;
  }

  template <class T>
  static constexpr T goes(T stall, T valid) {
    return law::is_idle(law::both(stall, valid));
  }
  template <class T>
  static constexpr T takes(T start, T stall, T valid) {
    return law::both(start, goes(stall, valid));
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("pipe_control", "Control of a pipeline: it goes unless a result waits at its end.");
    const auto start = reader.read(start_i);
    const auto stall = reader.read(stall_i);
    const auto valid = reader.read(valid_i);
    reader.drive(go_o, goes(stall, valid));
    reader.drive(take_o, takes(start, stall, valid));
    reader.drive(ready_o, goes(stall, valid));
  }

 private:
  void decode() {
    const std::int64_t start = start_i.read() ? 1 : 0;
    const std::int64_t stall = stall_i.read() ? 1 : 0;
    const std::int64_t valid = valid_i.read() ? 1 : 0;
    go_o.write(goes(stall, valid) != 0);
    take_o.write(takes(start, stall, valid) != 0);
    ready_o.write(goes(stall, valid) != 0);
  }
};

}  // namespace blysk
