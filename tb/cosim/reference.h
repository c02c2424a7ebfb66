// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/cosim/verilator_engine.h"

namespace blysk::cosim {

/// The device's reference.v, which is written by hand: Verilated for the formats that are checked in under rtl_verilog/.
/// Null if the device has none in this format, and for options that differ from the presets.
std::unique_ptr<verilator_engine> make_reference(const selection& asked);

}  // namespace blysk::cosim
