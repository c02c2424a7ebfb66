// SPDX-License-Identifier: Apache-2.0
#include "tb/export/netlist.h"

#include <cxxabi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <regex>
#include <set>
#include <stdexcept>

namespace blysk::verilog {
namespace {

using role = declaration::role;

/// "blysk_mul_uq_1_8_uq_1_8_uq_1_16": a type is a kind with its formats, so types and modules are one to one.
std::string module_name(const std::string& type) {
  std::string result = "blysk_";
  for (const char c : std::regex_replace(type, std::regex("-"), "m")) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      result += c;
    } else if (result.back() != '_') {
      result += '_';
    }
  }
  if (result.back() == '_') result.pop_back();
  return result;
}

std::vector<const sc_core::sc_port_base*> ports_of(const sc_core::sc_object& module) {
  std::vector<const sc_core::sc_port_base*> result;
  for (const sc_core::sc_object* child : module.get_child_objects()) {
    if (const auto* port = dynamic_cast<const sc_core::sc_port_base*>(child)) result.push_back(port);
  }
  return result;
}

std::vector<const sc_core::sc_module*> modules_of(const sc_core::sc_object& module) {
  std::vector<const sc_core::sc_module*> result;
  for (const sc_core::sc_object* child : module.get_child_objects()) {
    if (const auto* sub = dynamic_cast<const sc_core::sc_module*>(child)) result.push_back(sub);
  }
  return result;
}

class writer {
 public:
  explicit writer(const parts_list& parts) : parts_(parts) {}

  files result;

  /// Writes a module and those below it.
  /// \return  its ports
  std::vector<declaration> write(const sc_core::sc_module& module, const std::string& name,
                                 const std::string& title, const std::map<std::string, std::string>& notes) {
    scope nets = scope_of(module);
    std::string instances;
    for (const sc_core::sc_module* sub : modules_of(module)) instances += instance(*sub, name, nets);

    std::vector<declaration> ports;
    std::string wires;
    for (net& each : nets) {
      check(each, module);
      if (each.declared.where == role::wire) {
        wires += "  " + each.declared.text() + ";\n";
      } else {
        ports.push_back(each.declared);
      }
    }
    result[name + ".v"] = file_text(title, fmt::format("module {} (\n{}\n);\n\n{}\n{}\nendmodule\n", name,
                                                       port_list(ports, notes), wires, instances));
    return ports;
  }

 private:
  struct net {
    const sc_core::sc_interface* channel;
    declaration declared;
    int drivers = 0;
    int readers = 0;
  };
  using scope = std::vector<net>;

  /// The module's own ports and signals, by the channels behind them.
  static scope scope_of(const sc_core::sc_module& module) {
    scope nets;
    for (const sc_core::sc_object* child : module.get_child_objects()) {
      const sc_core::sc_interface* channel = dynamic_cast<const sc_core::sc_interface*>(child);
      if (const auto* port = dynamic_cast<const sc_core::sc_port_base*>(child))
        channel = port->get_interface();
      if (channel != nullptr) nets.push_back({channel, {child->basename(), role::wire, {}, false}});
    }
    for (const sc_core::sc_port_base* port : ports_of(module)) {
      find(nets, *port).declared.where = role::input;  // until a part drives it
    }
    return nets;
  }

  static net& find(scope& nets, const sc_core::sc_port_base& port) {
    const auto found = std::ranges::find(nets, port.get_interface(), &net::channel);
    if (found == nets.end()) throw std::logic_error(fmt::format("{} is bound past its parent", port.name()));
    return *found;
  }

  std::string instance(const sc_core::sc_module& module, const std::string& parent, scope& nets) {
    const parts_list::part* part = parts_.find(module);
    std::string type;
    std::string values;
    std::vector<declaration> declarations;
    if (part != nullptr) {
      type = leaf(module, *part);
      values = parameter_values(part->reader);
      declarations = part->reader.declarations();
    } else if (!modules_of(module).empty()) {
      type = parent + "_" + module.basename();
      declarations = write(module, type, fmt::format("// {} of {}.\n", module.basename(), parent), {});
    } else {
      throw std::logic_error(fmt::format("{} is not in its device's blocks()", module.name()));
    }

    std::string connections;
    for (const sc_core::sc_port_base* port : ports_of(module)) {
      net& bound = find(nets, *port);
      const declaration& declared =
          *std::ranges::find(declarations, std::string(port->basename()), &declaration::name);
      bound.declared.bits = declared.bits;
      if (declared.where == role::output) {
        ++bound.drivers;
        if (bound.declared.where == role::input) bound.declared.where = role::output;
      } else {
        ++bound.readers;
      }
      connections +=
          fmt::format("{}.{}({})", connections.empty() ? "" : ", ", declared.name, bound.declared.name);
    }
    return fmt::format("  {}{} {} ({});\n", type, values, module.basename(), connections);
  }

  std::string leaf(const sc_core::sc_module& module, const parts_list::part& part) {
    const std::string name = module_name(part.type);
    std::vector<std::string> ports;
    for (const sc_core::sc_port_base* port : ports_of(module)) ports.emplace_back(port->basename());
    const std::string text =
        part.reader.text(name, fmt::format("// {}, exported from the SystemC model.\n", part.type), ports);
    const auto [file, is_new] = result.emplace(name + ".v", text);
    if (!is_new && file->second != text) throw std::logic_error(name + " has two laws");
    return name;
  }

  static std::string parameter_values(const block_reader& reader) {
    std::string values;
    for (const instance_parameter& each : reader.parameters()) {
      values += fmt::format("{}.{}({})", values.empty() ? " #(" : ", ", each.name,
                            literal(each.value, reader.parameter_width(each.name)));
    }
    return values.empty() ? values : values + ")";
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

  static std::string port_list(const std::vector<declaration>& ports,
                               const std::map<std::string, std::string>& notes) {
    std::string result;
    for (const declaration& port : ports) {
      const auto note = notes.find(port.name);
      result +=
          fmt::format("    {}{}{}{}", port.text(), &port == &ports.back() ? "" : ",",
                      note == notes.end() ? "" : "  // " + note->second, &port == &ports.back() ? "" : "\n");
    }
    return result;
  }

  const parts_list& parts_;
};

}  // namespace

const parts_list::part* parts_list::find(const sc_core::sc_object& module) const {
  const auto found = parts_.find(&module);
  return found == parts_.end() ? nullptr : &found->second;
}

std::string parts_list::type_name(const std::type_info& type) {
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(type.name(), nullptr, nullptr, nullptr), std::free);
  return std::regex_replace(std::regex_replace(name.get(), std::regex("blysk::"), ""), std::regex(" >"), ">");
}

files netlist(const sc_core::sc_module& top, const std::string& name, const std::string& title,
              const std::map<std::string, std::string>& notes, const parts_list& parts) {
  writer result(parts);
  result.write(top, name, title, notes);
  return result.result;
}

std::vector<std::string> clock_ports(const sc_core::sc_module& top, const parts_list& parts) {
  std::set<const sc_core::sc_interface*> clocks;
  const auto collect = [&](const auto& self, const sc_core::sc_module& module) -> void {
    const parts_list::part* part = parts.find(module);
    for (const sc_core::sc_port_base* port : ports_of(module)) {
      if (part != nullptr && part->reader.is_clock(port->basename())) clocks.insert(port->get_interface());
    }
    for (const sc_core::sc_module* sub : modules_of(module)) self(self, *sub);
  };
  collect(collect, top);
  std::vector<std::string> result;
  for (const sc_core::sc_port_base* port : ports_of(top)) {
    if (clocks.contains(port->get_interface())) result.emplace_back(port->basename());
  }
  return result;
}

}  // namespace blysk::verilog
