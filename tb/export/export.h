// SPDX-License-Identifier: Apache-2.0
/// Verilog of a device, made from its elaborated SystemC.
#pragma once

#include <filesystem>
#include <string>

#include "tb/device.h"
#include "tb/export/netlist.h"

namespace blysk::verilog {

/// Name of the top module, "blysk_quadratic_q12".
std::string top_name(const device_options& options);

/// The device's modules (Verilog-2001, one to a file), the file list top.f, the FuseSoC description top.core and the
/// constraints top.sdc.
/// SystemC elaborates once: a process exports once, and has no other module.
/// \throws std::invalid_argument for options that no device has
files export_files(const device_options& options);

/// Writes them into a directory, which is made if it does not exist.
/// \throws std::invalid_argument for options that no device has, before anything is written
/// \throws std::ios_base::failure or std::filesystem::filesystem_error
void export_device(const device_options& options, const std::filesystem::path& directory);

/// The files of any device that has pins() and blocks() as quadratic.h has. Elaborates SystemC.
template <class Device>
files export_files(Device& device, const device_options& options) {
  pin_reader pins;
  device.pins(pins);
  sc_core::sc_start(sc_core::SC_ZERO_TIME);  // elaborates
  const parts_list parts(device.blocks());
  return export_files(device, options, pins.notes(), parts);
}

files export_files(const sc_core::sc_module& device, const device_options& options,
                   const std::map<std::string, std::string>& notes, const parts_list& parts);

}  // namespace blysk::verilog
