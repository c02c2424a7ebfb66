// SPDX-License-Identifier: Apache-2.0
#include "tb/export/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace blysk::verilog {

// Defined in quadratic_export.cpp, one object file per format; its header would elaborate them all here.
template <class Q, lobe Lobe>
files export_quadratic(const device_options& options);

namespace {

/// "device quadratic, format q12, coefficient derived, BRDF clamped", what was given alone.
std::string description(const device_options& options) {
  return fmt::format("device {}, format {}, coefficient {}{}, {}", options.device, options.format,
                     options.coefficient,
                     options.constant.empty() ? "" : ", constant 0." + options.constant + "b",
                     options.as_published ? "BRDF as published" : "BRDF clamped to [0, 1]");
}

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

std::string constraints_text(const std::vector<std::string>& clocks) {
  std::string text =
      "# SPDX-License-Identifier: Apache-2.0\n"
      "# 10 ns stands for the board's clock. No path is false: rst_n is synchronous, and what enters or "
      "leaves does so\n"
      "# within one period.\n";
  for (const std::string& clk : clocks) {
    text += fmt::format(
        "create_clock -name {0} -period 10 [get_ports {0}]\n"
        "set_input_delay -clock {0} 0 [remove_from_collection [all_inputs] [get_ports {0}]]\n"
        "set_output_delay -clock {0} 0 [all_outputs]\n",
        clk);
  }
  return text;
}

}  // namespace

std::string top_name(const device_options& options) {
  std::string name = fmt::format("blysk_{}_{}", options.device, options.format);
  std::ranges::replace(name, '-', '_');
  return name;
}

files export_files(const sc_core::sc_module& device, const device_options& options,
                   const std::map<std::string, std::string>& notes, const parts_list& parts) {
  const std::string name = top_name(options);
  const std::string what = description(options);
  files result =
      netlist(device, name, fmt::format("// {}, exported from the SystemC model.\n", what), notes, parts);
  std::string list;
  for (const auto& [file, text] : result) list += file + "\n";
  const std::string core = core_text(name, what, result);
  result[name + ".f"] = list;
  result[name + ".core"] = core;
  result[name + ".sdc"] = constraints_text(clock_ports(device, parts));
  return result;
}

files export_files(const device_options& options) {
  if (options.device != "quadratic")
    throw std::invalid_argument("device " + options.device + " does not exist");
  return visit_formats(options, [&]<class Q, lobe Lobe>() { return export_quadratic<Q, Lobe>(options); });
}

void export_device(const device_options& options, const std::filesystem::path& directory) {
  const files made = export_files(options);
  std::filesystem::create_directories(directory);
  for (const auto& [name, text] : made) {
    std::ofstream file;
    file.exceptions(std::ios::failbit | std::ios::badbit);
    file.open(directory / name, std::ios::binary);
    file << text;
    file.close();
  }
}

}  // namespace blysk::verilog
