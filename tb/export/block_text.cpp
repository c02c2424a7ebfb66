// SPDX-License-Identifier: Apache-2.0
#include "tb/export/block_text.h"

#include <fmt/format.h>

#include "tb/export/law_text.h"
#include "tb/export/lexis.h"

namespace blysk::verilog {

using netlist::declaration;

std::string block_text(const netlist::block& part, const std::string& module_name, const std::string& title,
                       const std::vector<std::string>& ports) {
  std::string result = "module " + module_name;
  std::string separator = " #(\n";
  for (const netlist::instance_parameter& each : part.parameters()) {
    const int width = parameter_width(part, each.name);
    result +=
        fmt::format("{}    parameter {}{} = {}", separator, range_text(width), each.name, literal(0, width));
    separator = ",\n";
  }
  if (!part.parameters().empty()) result += "\n)";
  std::vector<declaration> declared;
  declared.reserve(ports.size());
  for (const std::string& port : ports) declared.push_back(part.described(port));
  return file_text(
      title, fmt::format("{} (\n{}\n);\n\n{}\nendmodule\n", result, port_list(declared, {}), law_text(part)));
}

std::string port_list(const std::vector<declaration>& ports,
                      const std::map<std::string, std::string>& notes) {
  std::string result;
  for (const declaration& port : ports) {
    const bool is_last = &port == &ports.back();
    const auto known = notes.find(port.name);
    const std::string note = known != notes.end() ? known->second : port.carries ? port.carries->note() : "";
    result += fmt::format("    {}{}{}{}", declaration_text(port), is_last ? "" : ",", comment(note),
                          is_last ? "" : "\n");
  }
  return result;
}

}  // namespace blysk::verilog
