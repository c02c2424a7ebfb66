// SPDX-License-Identifier: Apache-2.0
/// The export of a device with what was measured of it: a comment at the head of its top module, and its constraints.
#pragma once

#include <string>

#include "tb/device.h"
#include "tb/export/export.h"

namespace blysk::cost {

/// The comment: what is known of the device's Verilog with that digest, a line for each figure.
std::string head_of(const selection& asked, const std::string& digest);

/// The files of verilog::export_files() with the figures of the embedded files of docs/tables. Those that belong to another
/// Verilog are left out. The digest by which they are found is that of the modules without the comment, so the comment
/// changes no digest.
/// \param device  elaborated as `asked` says, on a plain clock
/// \param name    of the top module; if it is not asked.top_name(), the digest is that of the modules under that name
verilog::files annotated_export(const netlist::elaborated& device, const selection& asked,
                                const std::string& name);

}  // namespace blysk::cost
