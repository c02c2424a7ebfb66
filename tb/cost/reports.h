// SPDX-License-Identifier: Apache-2.0
/// What synthesis tools are given, and their reports read.
#pragma once

#include <string>

#include "tb/cost/cost_row.h"

namespace blysk::cost {

/// A Verilog module `name` with the device inside and four pins, so that pins limit nothing: inputs come from a shift
/// register, and outputs go to registers at once and from those, if `load` says so, to a shift register.
/// \param asked  gives the top module's name and ports
std::string serial_wrapper(const selection& asked, const std::string& name);

/// A Verilog module `name` with the device's ports around a netlist whose ports were split into wires, "n_i[3]".
std::string split_wrapper(const selection& asked, const std::string& name);

/// Counts of a `stat -json` of Yosys after synth_ice40. `from` stays empty.
/// \throws usage_error for a text that is none
ice40_cells read_ice40_cells(const std::string& path, const std::string& text);

/// The clock that a `--report` of nextpnr says was reached, MHz.
double read_fmax(const std::string& path, const std::string& text);

/// Cells and area of a `stat -liberty` of Yosys, in areas of the library's NAND2X1.
/// \param liberty  the library's text
standard_cells read_standard_cells(const std::string& path, const std::string& text,
                                   const std::string& liberty);

/// The longest path from a `report_checks -path_delay max` of OpenSTA, ns.
/// \param period_ns  of the clock that it was given
double read_path_ns(const std::string& path, const std::string& text, double period_ns);

}  // namespace blysk::cost
