// SPDX-License-Identifier: Apache-2.0
/// The export of a device with what was measured of it: a comment at the head of its top module, and its constraints.
#pragma once

#include "tb/device.h"
#include "tb/export/export.h"

namespace blysk::cost {

/// The files of verilog::export_files() with the figures of the embedded files of docs/tables. Those that belong to another
/// Verilog are left out. The digest by which they are found is that of the modules without the comment, so the comment
/// changes no digest.
/// \param device  elaborated as `asked` says, on a plain clock
verilog::files annotated_export(const netlist::elaborated& device, const selection& asked);

}  // namespace blysk::cost
