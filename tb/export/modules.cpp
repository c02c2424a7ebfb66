// SPDX-License-Identifier: Apache-2.0
#include "tb/export/modules.h"

#include <cxxabi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <memory>
#include <regex>
#include <set>
#include <stdexcept>
#include <typeindex>
#include <typeinfo>
#include <utility>

#include "tb/export/block_text.h"
#include "tb/export/law_text.h"
#include "tb/export/lexis.h"

namespace blysk::verilog {
namespace {

using netlist::block;
using netlist::declaration;
using netlist::instance_parameter;
using netlist::modules_of_module;
using netlist::ports_of_module;
using role = declaration::role;

/// Name of a type as it may stand in Verilog, "stage_8" for stage<8>.
std::string plain_name(const std::string& type) {
  std::string result;
  for (const char c : std::regex_replace(type, std::regex("-"), "m")) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      result += c;
    } else if (!result.empty() && result.back() != '_') {
      result += '_';
    }
  }
  if (result.ends_with('_')) result.pop_back();
  return result;
}

/// The module's C++ type without namespaces.
std::string type_name(const sc_core::sc_object& module) {
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(typeid(module).name(), nullptr, nullptr, nullptr), std::free);
  return std::regex_replace(name.get(), std::regex(R"((\w+|\(anonymous namespace\))::)"), "");
}

class module_writer {
 public:
  /// \param name    of the top module, with which the others' names begin
  /// \param origin  what all files tell at their heads
  module_writer(const std::string& name, const std::string& origin, const netlist::elaborated& device)
      : name_(name), origin_(origin), parts_(device.parts()) {
    const auto ordered = netlist::in_order_of_data(device, netlist::registers_are::sources);
    for (std::size_t i = 0; i < ordered.size(); ++i) place_[ordered[i]] = i;
  }

  files result;

  /// Writes a module and those below it.
  /// \return  its ports
  std::vector<declaration> write(const sc_core::sc_module& module, const std::string& name,
                                 const std::map<std::string, std::string>& notes) {
    scope nets = scope_of(module);
    std::string instances;
    for (const sc_core::sc_module* sub : in_order(modules_of_module(module)))
      instances += instance(*sub, nets);

    std::vector<declaration> ports;
    for (const net& each : nets) {
      check(each, module);
      if (each.declared.where != role::wire) ports.push_back(each.declared);
    }
    std::string wires;
    std::ranges::stable_sort(nets, {}, &net::driven_at);
    for (const net& each : nets) {
      if (each.declared.where == role::wire) {
        const std::string format = each.declared.carries ? each.declared.carries->note() : "";
        wires += "  " + declaration_text(each.declared) + ";" +
                 comment(format.empty() ? "" : each.driver + ": " + format) + "\n";
      }
    }
    add(name, file_text(origin_, fmt::format("module {} (\n{}\n);\n\n{}\n{}\nendmodule\n", name,
                                             port_list(ports, notes), wires, instances)));
    return ports;
  }

 private:
  /// Modules of modules come first, in the order of their making.
  std::vector<const sc_core::sc_module*> in_order(std::vector<const sc_core::sc_module*> modules) const {
    const auto place = [this](const sc_core::sc_module* module) {
      const auto found = place_.find(module);
      return found == place_.end() ? 0 : found->second + 1;
    };
    std::ranges::stable_sort(modules, {}, place);
    return modules;
  }

  struct net {
    const sc_core::sc_interface* channel;
    declaration declared;
    int drivers = 0;
    int readers = 0;
    std::string driver = {};    // the instance
    std::size_t driven_at = 0;  // its place in the order of the text
  };
  using scope = std::vector<net>;

  /// The module's own ports and signals, by the channels behind them.
  static scope scope_of(const sc_core::sc_module& module) {
    scope nets;
    for (const sc_core::sc_object* child : module.get_child_objects()) {
      const sc_core::sc_interface* channel = dynamic_cast<const sc_core::sc_interface*>(child);
      if (const auto* port = dynamic_cast<const sc_core::sc_port_base*>(child))
        channel = port->get_interface();
      if (channel != nullptr) nets.push_back({channel, {child->basename(), role::wire, {}}});
    }
    for (const sc_core::sc_port_base* port : ports_of_module(module)) {
      net& bound = find(nets, *port);
      if (bound.declared.name != port->basename()) {
        throw std::logic_error(
            fmt::format("{} and {} of {} are bound to one net, and what lies below them cannot be told apart",
                        bound.declared.name, port->basename(), module.name()));
      }
      bound.declared.where = role::input;  // until a part drives it
    }
    return nets;
  }

  static net& find(scope& nets, const sc_core::sc_port_base& port) {
    const auto found = std::ranges::find(nets, port.get_interface(), &net::channel);
    if (found == nets.end()) throw std::logic_error(fmt::format("{} is bound past its parent", port.name()));
    return *found;
  }

  std::string instance(const sc_core::sc_module& module, scope& nets) {
    const block* part = parts_.find(module);
    std::string type;
    std::vector<declaration> declarations;
    if (part != nullptr) {
      type = leaf(module, *part);
      declarations = part->declarations();
    } else if (!modules_of_module(module).empty()) {
      type = name_ + "_" + plain_name(type_name(module));
      declarations = write(module, type, {});
    } else {
      throw std::logic_error(fmt::format("{} is not in its device's blocks()", module.name()));
    }

    std::string connections;
    for (const sc_core::sc_port_base* port : ports_of_module(module)) {
      net& bound = find(nets, *port);
      const declaration& declared =
          *std::ranges::find(declarations, std::string(port->basename()), &declaration::name);
      connect(bound, declared, module.basename());
      connections +=
          fmt::format("{}.{}({})", connections.empty() ? "" : ", ", declared.name, bound.declared.name);
    }
    const auto [values, meaning] =
        part != nullptr ? parameter_values(*part) : std::pair<std::string, std::string>{};
    const std::string head = fmt::format("  {}{} {} (", type, values, module.basename());
    constexpr std::size_t kLongest = 110;
    const bool is_long = head.size() + connections.size() > kLongest;
    return fmt::format("{}{}{}{});{}\n", head, is_long ? "\n      " : "", connections, is_long ? "\n  " : "",
                       comment(meaning));
  }

  void connect(net& bound, const declaration& declared, const std::string& instance) {
    declaration& own = bound.declared;
    own.bits = declared.bits;
    if (own.carries && declared.carries && own.carries->text() != declared.carries->text()) {
      throw std::logic_error(
          fmt::format("{} carries {} and {}", own.name, own.carries->text(), declared.carries->text()));
    }
    if (declared.where == role::output) {
      ++bound.drivers;
      bound.driver = instance;
      bound.driven_at = ++driven_;
      if (own.where == role::input) own.where = role::output;
      if (declared.carries) own.carries = declared.carries;
    } else {
      ++bound.readers;
      if (!own.carries) own.carries = declared.carries;
    }
  }

  std::string leaf(const sc_core::sc_module& module, const block& part) {
    std::vector<std::string> ports;
    for (const sc_core::sc_port_base* port : ports_of_module(module)) ports.emplace_back(port->basename());
    std::string name = leaf_name(typeid(module), part.name(ports));
    add(name, block_text(part, name, fmt::format("// {}\n{}", part.words(), origin_), ports));
    return name;
  }

  /// The types of blocks with their variants and the modules are one to one: a name that another has got is numbered.
  std::string leaf_name(const std::type_info& type, const std::string& wanted) {
    const std::pair<std::type_index, std::string> kind(type, wanted);
    const auto known = leaf_names_.find(kind);
    if (known != leaf_names_.end()) return known->second;
    const std::string base = name_ + "_" + wanted;
    std::string name = base;
    for (int i = 2; result.contains(name + ".v"); ++i) name = fmt::format("{}_{}", base, i);
    return leaf_names_[kind] = name;
  }

  void add(const std::string& name, const std::string& text) {
    const auto [file, is_new] = result.emplace(name + ".v", text);
    if (!is_new && file->second != text) throw std::logic_error(name + " would have two texts");
  }

  /// " #(.RAW(12'd3223))", and the numbers that the values stand for.
  static std::pair<std::string, std::string> parameter_values(const block& reader) {
    std::string values, meaning;
    for (const instance_parameter& each : reader.parameters()) {
      values += fmt::format("{}.{}({})", values.empty() ? " #(" : ", ", each.name,
                            literal(each.value, parameter_width(reader, each.name)));
      if (each.carries) meaning += (meaning.empty() ? "" : ", ") + each.carries->value(each.value);
    }
    return {values.empty() ? values : values + ")", meaning};
  }

  static void check(const net& each, const sc_core::sc_module& module) {
    const bool is_input = each.declared.where == role::input;
    const bool is_wire = each.declared.where == role::wire;
    if (each.drivers != (is_input ? 0 : 1)) {
      throw std::logic_error(
          fmt::format("{}.{} has {} drivers", module.name(), each.declared.name, each.drivers));
    }
    if ((is_input || is_wire) && each.readers == 0) {
      throw std::logic_error(fmt::format("{}.{} has no reader", module.name(), each.declared.name));
    }
  }

  const std::string name_;
  const std::string origin_;
  const netlist::parts_list& parts_;
  std::map<const sc_core::sc_module*, std::size_t> place_;
  std::size_t driven_ = 0;
  std::map<std::pair<std::type_index, std::string>, std::string> leaf_names_;
};

}  // namespace

files module_files(const netlist::elaborated& device, const std::string& name, const std::string& origin,
                   const std::map<std::string, std::string>& notes) {
  module_writer result(name, origin, device);
  result.write(device.device(), name, notes);
  return result.result;
}

}  // namespace blysk::verilog
