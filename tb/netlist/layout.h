// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/netlist/elaborated.h"

namespace blysk::netlist {

/// Whose waves a layout is for: those of SystemC name ports by port::wave, those of the exported Verilog by port::name.
enum class waves_of { systemc, verilog };

/// The layout of GTKWave for the waves of a device (a .gtkw file): clock, strobes and data as in fig. 3 of [P], results,
/// then every block in the order of the data; markers at the first write. Widths, fraction bits and signs are those of the ports and blocks. Beside ports
/// stand their values as real numbers; waves of the exported Verilog that lack them lose no more than these rows.
/// \param device  of which sc_start() was called
/// \param title   what the device is, in one line
/// \param root    scope of the device in the waves: "SystemC"; "TOP.blysk_quadratic_q12", as Verilator writes it
std::string layout_text(const elaborated& device, const std::string& title, const std::string& root,
                        waves_of whose);

}  // namespace blysk::netlist
