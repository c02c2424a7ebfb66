// SPDX-License-Identifier: Apache-2.0
/// Verilog of a device, made from its elaborated SystemC.
#pragma once

#include <optional>
#include <string>

#include "tb/device.h"
#include "tb/export/modules.h"

namespace blysk::verilog {

/// A clock that the device was seen to reach.
struct reached_clock {
  double period_ns;
  std::string words;  ///< where, "OSU018, docs/tables/..."
};

/// How long the results of a device with strobes take to settle.
struct reached_settling {
  double bound_ns;    ///< from the clock edge that loads the registers
  std::string words;  ///< where
};

/// What was measured of the device for its constraints.
struct measured_times {
  std::optional<reached_clock> clock = {};  ///< without one the period is an example
  std::optional<reached_settling> settling = {};
};

/// The device's modules (Verilog-2001, one to a file), the file list top.f, the FuseSoC description top.core, the
/// constraints top.sdc, the layout top.gtkw, which GTKWave reads with the waves that Verilator writes of it, and the test
/// bench top_bench.vt of bench_text().
/// \param device  on a plain clock; SystemC elaborates it here if it has not
/// \param name    of the top module
/// \param title   what the device is, in one line
files export_files(const netlist::elaborated& device, const std::string& name, const std::string& title,
                   const measured_times& times = {});

/// The same for a device as its user asks for it, which is elaborated: a process does it once.
files export_files(const selection& asked);

/// The constraints top.sdc alone. After elaboration.
std::string constraints_text(const netlist::elaborated& device, const measured_times& times);

}  // namespace blysk::verilog
