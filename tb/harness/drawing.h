// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/device.h"

namespace blysk::harness {

/// The figure of a device, drawn from its elaborated netlist in the language of Graphviz's dot: a node for each block, with
/// its number in the figure and what it is, one for each port, an edge for each reader of a net, with the net's name and
/// format. Clock and reset are left out. Elaborates the device: a process does that once.
std::string drawing_text(const selection& asked);

/// The drawing's name within pictures that dot makes of it: "netlist_" and a number that follows from all the rest of the
/// text.
std::string drawing_id(const std::string& text);

}  // namespace blysk::harness
