// SPDX-License-Identifier: Apache-2.0
/// A device in SystemC under its strobes, as an engine.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tb/delays.h"
#include "tb/device.h"
#include "tb/engine.h"

namespace blysk::harness {

inline constexpr double kClockPeriodNs = 10;

/// A device elaborated in SystemC, with clock, strobes and a monitor at its valid port.
///
/// Every write takes two clock cycles, and as many more as the device says that it needs to settle: strobes change with the
/// falling edges of clk, the strobe that writes by its trailing edge goes up and down again, the others go up as it goes
/// down if their value changes. The monitor reads the results at the next leading edge of the valid port.
/// SystemC elaborates once: a process makes one engine, or one of each of several devices, before it runs any. Their clocks go
/// on together, whichever runs. A device with `start` ends its run at a falling edge of the clock: half a period has to pass
/// before another device runs.
/// SystemC does not say when a disk is full: the end of the record is looked for in its file.
class systemc_engine : public recorded_engine {
 public:
  /// Waves have each delta cycle 1 ps after the one before it. Before trace().
  void record_deltas() { has_deltas_ = true; }

 protected:
  using recorded_engine::recorded_engine;

  bool has_deltas() const { return has_deltas_; }

 private:
  bool has_deltas_ = false;
};

/// When a row of the results was read, and how its write settled, ps.
struct write_timing {
  std::uint64_t read_at;  ///< the leading edge of the valid port, since the start

  /// From the clock edge before the valid port's leading edge to the last change of an output, and until none could change
  /// any more. A gap shorter than that is what the strobe cuts off: what comes later is not in it.
  std::uint64_t settled_after, busy_for;
};

/// A device in SystemC whose blocks take the time that was measured.
class timed_engine : public systemc_engine {
 public:
  /// Of the rows of the last run.
  virtual const std::vector<write_timing>& timings() const = 0;

 protected:
  using systemc_engine::systemc_engine;
};

/// Whether a VCD file, timescale 1 ps, ends as a whole line not longer than a clock period before `now_ps`.
bool ends_at(const std::string& vcd, double now_ps, double clock_period_ns = kClockPeriodNs);

/// \throws std::logic_error for a device without a strobe that writes by its trailing edge and a valid port
std::unique_ptr<systemc_engine> make_systemc(const selection& asked);

/// \param period_ns  of the clock, an even number of ps; a strobe comes half of it after the clock edge that loads the
///                   registers
/// \throws std::invalid_argument for a device without strobes, or whose nets take no delays
std::unique_ptr<timed_engine> make_timed(const selection& asked, device_delays delays, double period_ns);

}  // namespace blysk::harness
