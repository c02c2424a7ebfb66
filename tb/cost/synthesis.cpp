// SPDX-License-Identifier: Apache-2.0
// What scripts/synth does not do itself.
// synthesis prepare FOLDER --device D ...: the device's Verilog, its wrapper and what depends on its names, for the tools.
// synthesis collect FOLDER --device D ... --row FILE: the tools' reports into a row. Parts that have no report stay as the
//   row had them.
// synthesis delays FOLDER --device D ... --row FILE: the mapped netlist and its cells' delays into a file of delays.
// synthesis path --device D ... [--kind delays]: where the row, or the delays, stand below docs/tables.
// With --reference FILE: of the device written by hand in that Verilog instead of the export.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tb/cost/delays.h"
#include "tb/cost/digest.h"
#include "tb/cost/reports.h"
#include "tb/device_arguments.h"
#include "tb/export/export.h"
#include "tb/output_file.h"
#include "tb/program.h"

namespace {

using namespace blysk;
namespace fs = std::filesystem;

constexpr const char* kWrapper = "bench";
constexpr double kPeriodNs = 1000;  // longer than any path

std::string first_line(const fs::path& path) {
  const std::string text = cost::read_text(path);
  return text.substr(0, text.find('\n'));
}

std::string clock_of(const selection& asked) {
  const std::vector<port> ports = asked.of().ports(asked);
  return ports.at(find_role(ports, port::role::clock)).name;
}

/// The device written by hand, with the name and the fraction bits of the export.
/// \throws usage_error if the file is no module `reference` with parameter F = 8
verilog::files renamed(const std::string& reference, const selection& asked) {
  std::string text = cost::read_text(reference);
  const auto replace = [&](const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos)
      throw file_error(reference, 0,
                       fmt::format("has no '{}', expected module reference with parameter F = 8", from));
    text.replace(at, from.size(), to);
  };
  replace("module reference ", fmt::format("module {} ", asked.top_name()));
  replace("parameter F = 8", fmt::format("parameter F = {}", asked.format().substr(1)));
  return {{"reference.v", text}};
}

void prepare(const selection& asked, const std::string& reference, const fs::path& folder) {
  const verilog::files exported =
      reference.empty() ? verilog::export_files(asked) : renamed(reference, asked);
  for (const auto& [name, text] : exported) {
    if (name.ends_with(".v")) cost::write_text(folder / name, text);
  }
  const std::string clock = clock_of(asked);
  cost::write_text(folder / "wrapper" / "bench.v", cost::serial_wrapper(asked, kWrapper));
  cost::write_text(folder / "top", asked.top_name() + "\n");
  cost::write_text(folder / "digest", cost::verilog_digest(exported) + "\n");
  cost::write_text(folder / "path.tcl",
                   fmt::format("read_liberty osu018/cells.lib\n"
                               "read_verilog osu018/netlist.v\n"
                               "link_design {}\n"
                               "create_clock -name clk -period {} [get_ports {}]\n"
                               "set_input_delay 0 -clock clk [get_ports {{rst_n *_i *_i\\[*}}]\n"
                               "set_output_delay 0 -clock clk [all_outputs]\n"
                               "report_checks -path_delay max -digits 4\n",
                               asked.top_name(), kPeriodNs, clock));
  cost::write_text(folder / "wrapper" / "mapped.v", cost::split_wrapper(asked, "mapped"));
  cost::write_text(folder / "delays.tcl",
                   fmt::format("read_liberty delays/cells.lib\n"
                               "read_verilog delays/netlist.v\n"
                               "link_design {}\n"
                               "create_clock -name clk -period {} [get_ports {}]\n"
                               "set_output_delay 0 -clock clk [all_outputs]\n"
                               "report_checks -path_delay max -digits 4\n"
                               "write_sdf -divider . -no_timestamp -digits 3 delays/cells.sdf\n",
                               asked.top_name(), kPeriodNs, clock));
}

/// What a part of the folder says of its tools.
cost::origin origin_of(const fs::path& folder, const fs::path& part) {
  cost::origin from{first_line(folder / "digest"), {}, first_line(part / "script")};
  std::ifstream tools(part / "tools");
  for (std::string line; std::getline(tools, line);) {
    const std::size_t blank = line.find(' ');
    if (blank != std::string::npos) from.tools[line.substr(0, blank)] = line.substr(blank + 1);
  }
  return from;
}

void collect_delays(const selection& asked, const fs::path& folder, const std::string& path) {
  const fs::path part = folder / "delays";
  const cost::origin from = origin_of(folder, part);
  device_delays delays{.device = asked.of().name(),
                       .format = asked.format(),
                       .options = cost::given_options(asked),
                       .digest = from.digest,
                       .tools = from.tools,
                       .script = from.script,
                       .path = {},
                       .blocks = {}};
  cost::measure({.netlist = part / "netlist.json",
                 .sdf = part / "cells.sdf",
                 .library = part / "cells.lib",
                 .path = part / "path.txt"},
                asked.top_name(), clock_of(asked), delays);
  const std::string stored = cost::stored_text(cost::json_of(delays));
  cost::parse_delays(path, stored);
  cost::write_text(path, stored);
}

void collect(const selection& asked, const fs::path& folder, const std::string& path) {
  cost::cost_row row;
  if (fs::exists(path)) row = cost::parse_cost_row(path, cost::read_text(path));
  row.device = asked.of().name();
  row.format = asked.format();
  row.options = cost::given_options(asked);
  const auto is_there = [&](const char* part) { return fs::exists(folder / part / "done"); };
  const auto text = [](const fs::path& file) { return cost::read_text(file); };
  const auto ice40 = [&](const char* part) {
    const fs::path report = folder / part / "stat.json";
    cost::ice40_cells cells = cost::read_ice40_cells(report.string(), text(report));
    cells.from = origin_of(folder, folder / part);
    return cells;
  };
  if (is_there("ice40")) row.ice40 = ice40("ice40");
  if (is_there("ice40_dsp")) row.ice40_dsp = ice40("ice40_dsp");
  if (is_there("hx8k")) {
    const fs::path part = folder / "hx8k";
    cost::placement placed{origin_of(folder, part), first_line(part / "part"), {}, {}};
    for (int seed = 1; fs::exists(part / fmt::format("seed_{}.json", seed)); ++seed) {
      const fs::path report = part / fmt::format("seed_{}.json", seed);
      placed.seeds.push_back(seed);
      placed.fmax_mhz.push_back(std::round(100 * cost::read_fmax(report.string(), text(report))) / 100);
    }
    row.hx8k = placed;
  }
  if (is_there("osu018")) {
    const fs::path part = folder / "osu018";
    cost::standard_cells cells = cost::read_standard_cells((part / "stat.txt").string(),
                                                           text(part / "stat.txt"), text(part / "cells.lib"));
    cells.from = origin_of(folder, part);
    cells.path_ns = cost::read_path_ns((part / "path.txt").string(), text(part / "path.txt"), kPeriodNs);
    row.osu018 = cells;
  }
  // What was written can be read again, or it is not written.
  const std::string stored = cost::stored_text(json_of(row));
  cost::parse_cost_row(path, stored);
  cost::write_text(path, stored);
}

}  // namespace

int main(int argc, char** argv) {
  asked_device asked;
  std::string folder, row, reference, kind = "cost";
  CLI::App *prepares = nullptr, *collects = nullptr, *delays = nullptr;
  return run_program(
      argc, argv, "Prepares a device for synthesis tools and collects their reports",
      [&](CLI::App& program) {
        program.require_subcommand(1);
        const auto add = [&](const char* name, const char* what) {
          CLI::App* const action = program.add_subcommand(name, what);
          add_device_arguments(*action, asked, purpose::hardware);
          action->add_option("--reference", reference, "Verilog of the device written by hand");
          return action;
        };
        prepares = add("prepare", "write the device's Verilog and its wrapper");
        collects = add("collect", "make a row of the tools' reports");
        delays = add("delays", "make a file of delays of the mapped netlist");
        add("path", "print where the row stands below docs/tables")
            ->add_option("--kind", kind, "cost or delays")
            ->check(CLI::IsMember({"cost", "delays"}));
        for (CLI::App* each : {prepares, collects, delays})
          each->add_option("FOLDER", folder, "of the tools")->required();
        for (CLI::App* each : {collects, delays}) each->add_option("--row", row, "file to write")->required();
      },
      [&] {
        const selection chosen = asked.choose();
        if (prepares->parsed()) {
          prepare(chosen, reference, folder);
        } else if (collects->parsed()) {
          collect(chosen, folder, row);
        } else if (delays->parsed()) {
          collect_delays(chosen, folder, row);
        } else {
          fmt::print("{}\n", cost::row_path(reference.empty() ? kind : "reference", chosen));
        }
        return 0;
      });
}
