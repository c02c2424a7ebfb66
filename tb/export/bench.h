// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/netlist/elaborated.h"

namespace blysk::verilog {

/// A test bench in Verilog-2001 for an exported device: it reads what `blysk vectors` writes and appends the outputs, for
/// `blysk check`. Empty for a device that no host can talk to.
/// \param name  of the top module; the bench is NAME_bench
std::string bench_text(const netlist::elaborated& device, const std::string& name);

}  // namespace blysk::verilog
