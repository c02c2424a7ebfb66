// SPDX-License-Identifier: Apache-2.0
/// A device in SystemC under its strobes, as an engine.
#pragma once

#include <memory>
#include <string>

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
  virtual void stop_trace() = 0;
};

/// \throws std::invalid_argument for options that no device has
std::unique_ptr<systemc_engine> make_systemc(const device_options& options);

}  // namespace blysk::bench
