// SPDX-License-Identifier: Apache-2.0
/// A device in SystemC under its strobes, as an engine.
#pragma once

#include <memory>
#include <string>

#include "tb/device.h"
#include "tb/engine.h"

namespace blysk::harness {

inline constexpr double kClockPeriodNs = 10;

/// A device elaborated in SystemC, with clock, strobes and a monitor at its valid port.
///
/// Every write takes two clock cycles, and as many more as the device says that it needs to settle: strobes change with the
/// falling edges of clk, the strobe that writes by its trailing edge goes up and down again, the others go up as it goes
/// down if their value changes. The monitor reads the results at the next leading edge of the valid port.
/// SystemC elaborates once: a process makes one engine and makes it before it runs any.
/// SystemC does not say when a disk is full: the end of the record is looked for in its file.
class systemc_engine : public recorded_engine {
 protected:
  using recorded_engine::recorded_engine;
};

/// Whether a VCD file, timescale 1 ps, ends as a whole line not longer than a clock period before `now_ps`.
bool ends_at(const std::string& vcd, double now_ps);

/// \throws std::logic_error for a device without a strobe that writes by its trailing edge and a valid port
std::unique_ptr<systemc_engine> make_systemc(const selection& asked);

}  // namespace blysk::harness
