// SPDX-License-Identifier: Apache-2.0
/// An elaborated SystemC device as Verilog modules.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <systemc>
#include <tuple>
#include <typeinfo>
#include <vector>

#include "tb/export/block.h"

namespace blysk::verilog {

/// Text of each file by its name.
using files = std::map<std::string, std::string>;

/// What a device's pins() tell: a signal is bound to each, so that the device can be elaborated, and the notes are
/// kept.
class pin_reader {
 public:
  /// \param note  number in the figure and meaning
  template <class Port>
  void pin(Port& port, const std::string& note) {
    using value = std::remove_cvref_t<decltype(port.read())>;
    auto signal = std::make_shared<sc_core::sc_signal<value>>(sc_core::sc_gen_unique_name("pin"));
    port(*signal);
    signals_.push_back(std::move(signal));
    notes_[port.basename()] = note;
  }

  /// \param format  Q-format of what the pin carries
  template <class Port, class Format>
  void pin(Port& port, const std::string& note, Format) {
    constexpr int integer_bits = Format::width - Format::frac - (Format::is_signed ? 1 : 0);
    pin(port, note + ", " + (Format::is_signed ? "SQ" : "UQ") + std::to_string(integer_bits) + "." +
                  std::to_string(Format::frac));
  }

  const std::map<std::string, std::string>& notes() const { return notes_; }

 private:
  std::vector<std::shared_ptr<void>> signals_;
  std::map<std::string, std::string> notes_;
};

/// The leaf blocks of a device, each described by itself.
class parts_list {
 public:
  struct part {
    std::string type;  ///< "mul<uq<1, 8>, uq<1, 8>, uq<1, 16>>"
    block_reader reader;
  };

  /// \param blocks  a device's blocks(): a tie of its leaf modules
  template <class... Blocks>
  explicit parts_list(const std::tuple<Blocks&...>& blocks) {
    std::apply([this](const auto&... block) { (this->add(block, typeid(block)), ...); }, blocks);
  }

  const part* find(const sc_core::sc_object& module) const;

 private:
  template <class Block>
  void add(const Block& block, const std::type_info& type) {
    part& added = parts_[&block];
    added.type = type_name(type);
    block.describe(added.reader);
  }

  static std::string type_name(const std::type_info& type);

  std::map<const sc_core::sc_object*, part> parts_;
};

/// A device's modules, the top's name.v among them.
/// \param top    elaborated
/// \param name   of the top module
/// \param title  comment lines at the head of the top module's file
/// \param notes  on the top module's ports
/// \throws std::logic_error for a leaf module that is not in the parts list, a net with no driver, more than one, or
///         no reader, and for a port that its block does not describe
files netlist(const sc_core::sc_module& top, const std::string& name, const std::string& title,
              const std::map<std::string, std::string>& notes, const parts_list& parts);

/// Names of the top module's ports that clock registers.
std::vector<std::string> clock_ports(const sc_core::sc_module& top, const parts_list& parts);

}  // namespace blysk::verilog
