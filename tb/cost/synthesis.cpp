// SPDX-License-Identifier: Apache-2.0
// What scripts/synth does not do itself.
// synthesis prepare FOLDER --device D ...: the device's Verilog, its wrapper and what depends on its names, for the tools.
// synthesis collect FOLDER --device D ... --row FILE: the tools' reports into a row. Parts that have no report stay as the
//   row had them.
// synthesis path --device D ...: where the row stands below docs/tables.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <systemc>

#include "tb/cost/digest.h"
#include "tb/cost/reports.h"
#include "tb/device_arguments.h"
#include "tb/export/export.h"
#include "tb/output_file.h"
#include "tb/run_program.h"

namespace {

using namespace blysk;
namespace fs = std::filesystem;

constexpr const char* kWrapper = "bench";
constexpr double kPeriodNs = 1000;  // longer than any path

std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw file_error(path.string(), 0, "cannot be read, expected a file that scripts/synth left");
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_file(const fs::path& path, const std::string& text) {
  output_file file(path.string());
  file.write(text);
  file.close();
  file.commit();
}

std::string first_line(const fs::path& path) {
  const std::string text = read_file(path);
  return text.substr(0, text.find('\n'));
}

void prepare(const selection& asked, const fs::path& folder) {
  const verilog::files exported = verilog::export_files(asked);
  for (const auto& [name, text] : exported) {
    if (name.ends_with(".v")) write_file(folder / name, text);
  }
  std::string clock;
  for (const port& each : of_role(asked.of().ports(asked), port::role::clock)) clock = each.name;
  write_file(folder / "wrapper" / "bench.v", cost::serial_wrapper(asked, kWrapper));
  write_file(folder / "top", asked.top_name() + "\n");
  write_file(folder / "digest", cost::verilog_digest(exported) + "\n");
  write_file(folder / "path.tcl", fmt::format("link_design {}\n"
                                              "create_clock -name clk -period {} [get_ports {}]\n"
                                              "set_output_delay 0 -clock clk [all_outputs]\n"
                                              "report_checks -path_delay max -digits 4\n",
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

void collect(const selection& asked, const fs::path& folder, const std::string& path) {
  cost::cost_row row;
  if (fs::exists(path)) row = cost::parse_cost_row(path, read_file(path));
  row.device = asked.of().name();
  row.format = asked.format();
  row.options = cost::given_options(asked);
  const auto is_there = [&](const char* part) { return fs::exists(folder / part / "done"); };
  const auto text = [](const fs::path& file) { return read_file(file); };
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
  write_file(path, stored);
}

int run(int argc, char** argv) {
  sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);
  CLI::App program{"Prepares a device for synthesis tools and collects their reports", "synthesis"};
  program.require_subcommand(1);
  asked_device asked;
  std::string folder, row;
  const auto add = [&](const char* name, const char* what) {
    CLI::App* const action = program.add_subcommand(name, what);
    add_device_arguments(*action, asked, purpose::hardware);
    return action;
  };
  auto* const prepares = add("prepare", "write the device's Verilog and its wrapper");
  auto* const collects = add("collect", "make a row of the tools' reports");
  auto* const paths = add("path", "print where the row stands below docs/tables");
  for (CLI::App* each : {prepares, collects}) each->add_option("FOLDER", folder, "of the tools")->required();
  collects->add_option("--row", row, "file to write")->required();
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return program.exit(success);
  } catch (const CLI::Error& error) {
    throw usage_error(fmt::format("{}, see synthesis --help", error.what()));
  }
  const selection chosen = asked.choose();
  if (prepares->parsed()) prepare(chosen, folder);
  if (collects->parsed()) collect(chosen, folder, row);
  if (paths->parsed()) fmt::print("{}\n", cost::row_path("cost", chosen));
  return 0;
}

}  // namespace

int sc_main(int, char**) {
  return 0;
}  // SystemC's library asks for one

int main(int argc, char** argv) {
  return blysk::run_program("synthesis", [&] { return run(argc, argv); });
}
