// SPDX-License-Identifier: Apache-2.0
/// A leaf block as a Verilog module.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tb/netlist/block.h"

namespace blysk::verilog {

/// The module, its ports in the order given.
/// \throws std::logic_error for a port that is not described, or not used
std::string block_text(const netlist::block& part, const std::string& module_name, const std::string& title,
                       const std::vector<std::string>& ports);

/// The ports, a line each with the note of its name, or its format.
std::string port_list(const std::vector<netlist::declaration>& ports,
                      const std::map<std::string, std::string>& notes);

}  // namespace blysk::verilog
