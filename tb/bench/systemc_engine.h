// SPDX-License-Identifier: Apache-2.0
/// A device in SystemC under its strobes, as an engine.
#pragma once

#include <memory>
#include <string>
#include <systemc>

#include "tb/device.h"
#include "tb/engine.h"

namespace blysk::bench {

inline constexpr double kClockPeriodNs = 10;

/// The device of the options, elaborated in SystemC, with clock, strobes and a monitor at output 29.
///
/// Every write takes two clock cycles: strobes change with the falling edges of clk, 17 goes up and down again, the
/// other registers' strobes go up as it goes down if their value changes. The monitor reads the outputs at the next
/// leading edge of 29.
/// SystemC elaborates once: a process makes one engine and makes it before it runs any.
class systemc_engine : public clocked_engine {
 public:
  /// Records the waves from now on in a VCD file, timescale 1 ps. Before the first run.
  /// \param path  without the ending .vcd, which SystemC appends
  virtual void trace(const std::string& path) = 0;

  /// Ends the record and closes its file.
  /// \return  whether its end is in the file: SystemC does not say when a disk is full
  virtual bool stop_trace() = 0;
};

/// Whether a VCD file, timescale 1 ps, ends as a whole line not longer than a clock period before `now`.
bool ends_at(const std::string& vcd, const sc_core::sc_time& now);

/// \throws std::invalid_argument for options that no device has
std::unique_ptr<systemc_engine> make_systemc(const device_options& options);

}  // namespace blysk::bench
