// SPDX-License-Identifier: Apache-2.0
/// SystemC runs a device, and what it saw is written down for a Verilog simulator to see the same.
#pragma once

#include <filesystem>
#include <string>

#include "tb/export/modules.h"

namespace blysk::verilog {

/// Runs the device for some cycles, all its inputs random legal codes (each end as often as one code in eight), and
/// writes two files into the directory: vectors.txt, the inputs and outputs of each cycle before the rising edge of clk;
/// replay.v, a bench that applies them to the module and says "CYCLES cycles replayed, 0 differ". The clock is the pin
/// clk, if there is one; rst_n is low in the first cycle, which is not compared, and now and then later.
/// \throws std::ios_base::failure
void write_replay(const netlist::elaborated& device, const std::string& module_name, int cycles,
                  const std::filesystem::path& directory);

/// Writes files into a directory that is there.
/// \throws std::ios_base::failure
void write_files(const files& texts, const std::filesystem::path& directory);

}  // namespace blysk::verilog
