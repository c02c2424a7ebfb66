// SPDX-License-Identifier: Apache-2.0
/// Delays of a device's blocks as files, docs/tables/<identifier>/delays_<format>.json, and how they are measured: from the
/// mapped netlist of Yosys and the delays of its cells by OpenSTA.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tb/delays.h"
#include "tb/device.h"

namespace blysk::cost {

nlohmann::ordered_json json_of(const device_delays& delays);

/// \param path  for messages
/// \throws usage_error for text that holds no delays
device_delays parse_delays(const std::string& path, const std::string& text);

/// Delays that were measured of the Verilog that the device exports today.
/// \param file    of scripts/synth --delays; empty for the embedded one
/// \param digest  of today's Verilog
/// \throws usage_error if there is none, or it belongs to another device, format, choice of options or Verilog;
///         std::invalid_argument for a device that takes its inputs by start and ready
device_delays read_delays(const std::string& file, const selection& asked, const std::string& digest);

/// The digest of the Verilog that a device exports, made in a process of its own: SystemC elaborates once in each.
/// \throws std::runtime_error if it cannot be exported, std::invalid_argument if its format is not in this build
std::string digest_of(const selection& asked);

/// What the tools leave of a mapped device.
struct mapped_files {
  std::string netlist;  ///< path of a `write_json` of Yosys, a module for each kind of block
  std::string sdf;      ///< path of a `write_sdf -divider . -digits 3` of OpenSTA
  std::string library;  ///< path of the cells' Liberty file
  std::string path;     ///< path of a `report_checks -path_delay max` of OpenSTA
};

/// The longest paths within each block, with the delays that its cells have in the design: their loads are those of the
/// whole device. The edges of the cells' unate arcs are told apart within a block.
/// \param top         the netlist's top module
/// \param clock_name  its clock
/// \param to          gets blocks, path and bounds
/// \throws usage_error for files that cannot be read; std::runtime_error for cells without a delay or in a loop
void measure(const mapped_files& files, const std::string& top, const std::string& clock_name,
             device_delays& to);

}  // namespace blysk::cost
