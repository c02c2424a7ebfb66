// SPDX-License-Identifier: Apache-2.0
/// An elaborated device as Verilog modules.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tb/netlist/elaborated.h"

namespace blysk::verilog {

/// Text of each file by its name.
using files = std::map<std::string, std::string>;

/// A device's modules, the top's name.v among them. The others are named after the top and their kinds, so that
/// devices of several formats can stand in one design.
/// Instances stand in the order of the data, registers first.
/// \param device  after elaboration
/// \param name    of the top module
/// \param origin  comment lines at the head of every file
/// \param notes   on the top module's ports
/// \throws std::logic_error for a leaf module that is not in the parts list, a port that its block does not describe, a
///         net with no driver, more than one, no reader or two formats, a module of modules that has two ports on one
///         net, and two modules of one type that are not the same
files module_files(const netlist::elaborated& device, const std::string& name, const std::string& origin,
                   const std::map<std::string, std::string>& notes);

}  // namespace blysk::verilog
