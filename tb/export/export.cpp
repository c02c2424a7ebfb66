// SPDX-License-Identifier: Apache-2.0
#include "tb/export/export.h"

#include <fmt/format.h>

#include <algorithm>

namespace blysk::verilog {

namespace {

std::string core_text(const std::string& name, const std::string& what, const files& modules) {
  std::string list;
  for (const auto& [file, text] : modules) list += fmt::format("      - {}\n", file);
  return fmt::format(
      "CAPI=2:\n"
      "# SPDX-License-Identifier: Apache-2.0\n"
      "name: blysk:devices:{0}\n"
      "description: \"{1}\"\n"
      "filesets:\n"
      "  rtl:\n"
      "    file_type: verilogSource\n"
      "    files:\n"
      "{2}"
      "  constraints:\n"
      "    file_type: SDC\n"
      "    files:\n"
      "      - {0}.sdc\n"
      "targets:\n"
      "  default:\n"
      "    filesets: [rtl, constraints]\n"
      "    toplevel: {0}\n"
      "  lint:\n"
      "    default_tool: verilator\n"
      "    filesets: [rtl]\n"
      "    tools:\n"
      "      verilator:\n"
      "        mode: lint-only\n"
      "        verilator_options: [-Wall]\n"
      "    toplevel: {0}\n",
      name, what, list);
}

std::string constraints_text(const std::vector<pin>& pins, const std::vector<std::string>& clocks) {
  const auto ports = [&](bool is_input) {
    std::string names;
    for (const pin& each : pins) {
      const bool is_clock = std::ranges::find(clocks, each.name) != clocks.end();
      if (each.is_input == is_input && !is_clock) names += (names.empty() ? "" : " ") + each.name;
    }
    return names;
  };
  std::string text =
      "# SPDX-License-Identifier: Apache-2.0\n"
      "# clk_period, in ns, is an example: set your clock's. Delays of 0 leave inputs and outputs the whole "
      "period; set\n"
      "# what your board takes of it. No path is false: reset is synchronous.\n"
      "set clk_period 10.0\n";
  for (const std::string& clk : clocks) {
    text += fmt::format("create_clock -name {0} -period $clk_period [get_ports {0}]\n", clk);
    text += fmt::format("set_input_delay 0 -clock {} [get_ports {{{}}}]\n", clk, ports(true));
    text += fmt::format("set_output_delay 0 -clock {} [get_ports {{{}}}]\n", clk, ports(false));
  }
  return text;
}

}  // namespace

std::unique_ptr<model> make_model(const device_options& options) {
// NOLINTBEGIN(bugprone-macro-parentheses): a type cannot stand in any
#define BLYSK_DEVICE(identifier, name)                                                                    \
  if (options.device == name) {                                                                           \
    return visit_format(options, [&]<class Q>() { return make_model<devices::identifier, Q>(options); }); \
  }
// NOLINTEND(bugprone-macro-parentheses)
#include "tb/devices.def"
#undef BLYSK_DEVICE
  throw std::invalid_argument("device " + options.device + " does not exist");
}

std::string top_name(const device_options& options) {
  std::string name = fmt::format("blysk_{}_{}", options.device, options.format);
  std::ranges::replace(name, '-', '_');
  return name;
}

files export_files(const model& device, const std::string& name, const std::string& title) {
  std::map<std::string, std::string> notes;
  for (const pin& each : device.pins()) notes[each.name] = each.note;
  files result =
      netlist(device.device(), name, fmt::format("// {}, exported from the SystemC model.\n", title), notes,
              device.parts());
  std::string list;
  for (const auto& [file, text] : result) list += file + "\n";
  const std::string core = core_text(name, title, result);
  result[name + ".f"] = list;
  result[name + ".core"] = core;
  result[name + ".sdc"] = constraints_text(device.pins(), clock_ports(device.device(), device.parts()));
  return result;
}

files export_files(const model& device, const device_options& options) {
  return export_files(device, top_name(options),
                      fmt::format("device {}, format {}{}{}", options.device, options.format,
                                  device.options().empty() ? "" : ", ", device.options()));
}

}  // namespace blysk::verilog
