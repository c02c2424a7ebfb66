// SPDX-License-Identifier: Apache-2.0
/// An elaborated SystemC device as Verilog modules.
#pragma once

#include <map>
#include <string>
#include <systemc>
#include <tuple>
#include <vector>

#include "tb/export/block.h"

namespace blysk::verilog {

/// Text of each file by its name.
using files = std::map<std::string, std::string>;

/// The leaf blocks of a device, each described by itself.
class parts_list {
 public:
  /// \param blocks  a device's blocks(): a tie of its leaf modules
  template <class... Blocks>
  explicit parts_list(const std::tuple<Blocks&...>& blocks) {
    std::apply([this](const auto&... block) { (block.describe(parts_[&block]), ...); }, blocks);
  }

  /// The block's description, or null for what is no leaf.
  const block_reader* find(const sc_core::sc_object& module) const;

 private:
  std::map<const sc_core::sc_object*, block_reader> parts_;
};

/// A device's modules, the top's name.v among them. The others are named after the top and their kinds, so that
/// devices of several formats can stand in one design.
/// \param top     elaborated
/// \param name    of the top module
/// \param origin  comment lines at the head of every file
/// \param notes   on the top module's ports
/// \throws std::logic_error for a leaf module that is not in the parts list, a port that its block does not describe, a
///         net with no driver, more than one, no reader or two formats, a module of modules that has two ports on one
///         net, and two modules of one type that are not the same
files netlist(const sc_core::sc_module& top, const std::string& name, const std::string& origin,
              const std::map<std::string, std::string>& notes, const parts_list& parts);

/// Names of the top module's ports that clock registers.
std::vector<std::string> clock_ports(const sc_core::sc_module& top, const parts_list& parts);

}  // namespace blysk::verilog
