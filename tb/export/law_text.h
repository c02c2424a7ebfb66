// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/netlist/block.h"

namespace blysk::verilog {

/// Wires and statements of a module: the laws of a block, written down at the widths that they need.
/// \throws std::logic_error for a port that is described, and not used
std::string law_text(const netlist::block& part);

/// Bits of the named parameter that the block uses.
/// \throws std::logic_error if it uses none
int parameter_width(const netlist::block& part, const std::string& name);

}  // namespace blysk::verilog
