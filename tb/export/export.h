// SPDX-License-Identifier: Apache-2.0
/// Verilog of a device, made from its elaborated SystemC.
#pragma once

#include <memory>
#include <string>

#include "tb/device.h"
#include "tb/export/model.h"

namespace blysk::verilog {

/// Tags of the devices.
namespace devices {
#define BLYSK_DEVICE(identifier, name) struct identifier;
#include "tb/devices.def"
#undef BLYSK_DEVICE
}  // namespace devices

/// The device in format Q, defined in devices/<identifier>.cpp, which is compiled once for each format.
/// \throws std::invalid_argument for options that the device does not have
template <class Device, class Q>
std::unique_ptr<model> make_model(const device_options& options);

/// The device of the options.
/// \throws std::invalid_argument for options that no device has
std::unique_ptr<model> make_model(const device_options& options);

/// Name of the top module, "blysk_quadratic_q12".
std::string top_name(const device_options& options);

/// The device's modules (Verilog-2001, one to a file), the file list top.f, the FuseSoC description top.core and the
/// constraints top.sdc.
/// \param name   of the top module
/// \param title  what the device is, in one line
files export_files(const model& device, const std::string& name, const std::string& title);

/// The same for the device of the options.
files export_files(const model& device, const device_options& options);

}  // namespace blysk::verilog
