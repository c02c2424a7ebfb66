// SPDX-License-Identifier: Apache-2.0
#include "tb/export/export.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "tb/export/bench.h"
#include "tb/netlist/layout.h"

namespace blysk::verilog {

namespace {

// The file set of the bench, its parameters, and the target that runs it.
constexpr const char* kBenchFiles =
    "  bench:\n"
    "    file_type: verilogSource\n"
    "    files:\n"
    "      - {0}_bench.vt\n"
    "parameters:\n"
    "  vectors:\n"
    "    datatype: file\n"
    "    paramtype: plusarg\n"
    "    description: what blysk vectors writes\n"
    "  answers:\n"
    "    datatype: file\n"
    "    paramtype: plusarg\n"
    "    description: file to write, for blysk check\n";
constexpr const char* kBenchTarget =
    "  sim:\n"
    "    default_tool: icarus\n"
    "    filesets: [rtl, bench]\n"
    "    parameters: [vectors, answers]\n"
    "    tools:\n"
    "      icarus:\n"
    "        iverilog_options: [-g2001]\n"
    "      verilator:\n"
    "        mode: binary\n"
    "        verilator_options: [--timing, -Wno-fatal]\n"
    "    toplevel: {0}_bench\n";

std::string core_text(const std::string& name, const std::string& what, const files& modules,
                      bool has_bench) {
  std::string list;
  for (const auto& [file, text] : modules) list += fmt::format("      - {}\n", file);
  return fmt::format(
      "CAPI=2:\n"
      "# SPDX-License-Identifier: Apache-2.0\n"
      "name: blysk:devices:{0}:{3}\n"
      "description: \"{1}\"\n"
      "license: Apache-2.0\n"
      "filesets:\n"
      "  rtl:\n"
      "    file_type: verilogSource\n"
      "    files:\n"
      "{2}"
      "  constraints:\n"
      "    file_type: SDC\n"
      "    files:\n"
      "      - {0}.sdc\n"
      "{4}"
      "targets:\n"
      "  default:\n"
      "    filesets: [rtl, 'is_toplevel? (constraints)']\n"  // a core that depends on this one has its own
      "    toplevel: {0}\n"
      "  lint:\n"
      "    default_tool: verilator\n"
      "    filesets: [rtl]\n"
      "    tools:\n"
      "      verilator:\n"
      "        mode: lint-only\n"
      "        verilator_options: [-Wall]\n"
      "    toplevel: {0}\n"
      "  synth:\n"
      "    default_tool: yosys\n"
      "    filesets: [rtl, constraints]\n"
      "    tools:\n"
      "      yosys:\n"
      "        arch: ice40\n"
      "        output_format: json\n"
      "    toplevel: {0}\n"
      "{5}",
      name, what, list, BLYSK_VERSION, has_bench ? fmt::format(kBenchFiles, name) : "",
      has_bench ? fmt::format(kBenchTarget, name) : "");
}

}  // namespace

std::string constraints_text(const netlist::elaborated& device, const measured_times& times) {
  const std::optional<reached_clock>& clock = times.clock;
  std::vector<port> ports;
  for (const auto& each : device.ports()) ports.push_back(each->what);
  const auto names = [&](auto&& is_wanted) {
    std::vector<std::string> found;
    for (const port& each : ports) {
      if (!each.is_inner && is_wanted(each)) found.push_back(each.name);
    }
    return found;
  };
  const auto clocks = names([](const port& each) { return each.is == port::role::clock; });
  const auto inputs = names([](const port& each) { return each.is_input() && each.is != port::role::clock; });
  const auto outputs = names([](const port& each) { return !each.is_input(); });
  const auto results = names([](const port& each) { return each.is == port::role::result; });
  std::string text = "# SPDX-License-Identifier: Apache-2.0\n";
  if (clock) {
    text += fmt::format(
        "# clk_period, in ns, is what the longest path takes in {}. In other cells it is another.\n",
        clock->words);
  } else {
    text += "# clk_period, in ns, is an example: no clock of this device was measured. Set your clock's.\n";
  }
  text += fmt::format(
      "# Delays of 0 leave inputs and outputs the whole period; set what your board takes of it. No path is "
      "false: reset "
      "is\n# synchronous.\nset clk_period {:.1f}\n",
      clock ? std::ceil(clock->period_ns * 10) / 10 : 10.0);
  const bool has_strobes = protocol_of(ports) == protocol::strobes;
  if (has_strobes) {
    text +=
        "# strobe_gap: clock cycles from the edge that loads the last register of a write to the edge that "
        "samples its\n"
        "# results. With a shorter clk_period the host waits more of them between two strobes.\n"
        "set strobe_gap 1\n";
    if (times.settling) {
      text += fmt::format(
          "# The results settle within {0:.3f} ns of the edge in {1}.\n"
          "# Without its #, the next line makes a host wait for that at any clk_period.\n"
          "# set strobe_gap [expr {{int(ceil({0:.3f} / $clk_period))}}]\n",
          times.settling->bound_ns, times.settling->words);
    }
  }
  for (const std::string& clk : clocks) {
    text += fmt::format("create_clock -name {0} -period $clk_period [get_ports {0}]\n", clk);
    text += fmt::format("set_input_delay 0 -clock {} [get_ports {{{}}}]\n", clk, fmt::join(inputs, " "));
    text += fmt::format("set_output_delay 0 -clock {} [get_ports {{{}}}]\n", clk, fmt::join(outputs, " "));
  }
  if (has_strobes) {
    text += fmt::format(
        "set_multicycle_path $strobe_gap -setup -to [get_ports {{{0}}}]\n"
        "set_multicycle_path [expr {{$strobe_gap - 1}}] -hold -to [get_ports {{{0}}}]\n",
        fmt::join(results, " "));
  }
  if (has_strobes && times.settling) {
    text += fmt::format(
        "# Without its #, the next line asks for the time of these cells, in which the results settle, "
        "whatever "
        "clk_period is;\n"
        "# it then counts instead of the multicycle paths.\n"
        "# set_max_delay {:.3f} -to [get_ports {{{}}}]\n",
        times.settling->bound_ns, fmt::join(results, " "));
  }
  return text;
}

files export_files(const netlist::elaborated& device, const std::string& name, const std::string& title,
                   const measured_times& times) {
  sc_core::sc_start(sc_core::SC_ZERO_TIME);  // elaborates: what ports are bound to is known then
  std::map<std::string, std::string> notes;
  for (const auto& each : device.ports()) notes[each->what.name] = each->what.text();
  files result =
      module_files(device, name, fmt::format("// {}, exported from the SystemC model.\n", title), notes);
  std::string list;
  for (const auto& [file, text] : result) list += file + "\n";
  const std::string bench = bench_text(device, name);
  const std::string core = core_text(name, title, result, !bench.empty());
  result[name + ".f"] = list;
  if (!bench.empty()) result[name + "_bench.vt"] = bench;
  result[name + ".core"] = core;
  result[name + ".sdc"] = constraints_text(device, times);
  result[name + ".gtkw"] = netlist::layout_text(device, title, "TOP." + name, netlist::waves_of::verilog);
  return result;
}

files export_files(const selection& asked) {
  return export_files(*asked.of().elaborate(asked, 0), asked.top_name(), asked.text());
}

}  // namespace blysk::verilog
