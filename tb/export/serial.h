// SPDX-License-Identifier: Apache-2.0
/// A device behind three pins, for packages and boards that have few.
#pragma once

#include <string>

#include "tb/netlist/elaborated.h"

namespace blysk::verilog {

/// Verilog-2001 of NAME_serial: the device behind a serial line of 8 data bits, without parity, with one stop bit. A line of
/// `blysk vectors` goes in and comes back with the outputs appended, as `blysk check` takes it.
/// \param name   of the device's top module
/// \param title  what the device is, in one line
/// \throws std::invalid_argument for a device without strobes
std::string serial_text(const netlist::elaborated& device, const std::string& name, const std::string& title);

/// Its pins on Lattice's breakout board of the iCE40 HX8K, for nextpnr (a .pcf file).
std::string serial_pins(const std::string& name);

}  // namespace blysk::verilog
