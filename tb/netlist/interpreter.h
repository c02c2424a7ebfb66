// SPDX-License-Identifier: Apache-2.0
/// The netlist of a device as an engine: its blocks' laws, evaluated along its wires, without a simulation.
#pragma once

#include <memory>

#include "tb/device.h"
#include "tb/engine.h"
#include "tb/netlist/elaborated.h"

namespace blysk::netlist {

/// Computes the results that follow from the data ports when every register has been written: registers are transparent,
/// q = d, their strobes and resets are not read. Each drive wraps to the bits and sign of its port, as wires do.
/// Ends SystemC's elaboration: whatever else a process elaborates is made before. No simulated time passes.
/// \throws std::logic_error for a loop (also one through a register), an input that nothing drives, and a result that
///         depends on a port without a column, such as a strobe
std::unique_ptr<engine> make_interpreter(const elaborated& device);

/// The same for a device of the list. A process makes one.
std::unique_ptr<engine> make_interpreter(const selection& asked);

}  // namespace blysk::netlist
