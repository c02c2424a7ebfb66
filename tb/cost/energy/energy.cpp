// SPDX-License-Identifier: Apache-2.0
// What energy.sh does not do itself.
// energy half DELAYS.json: half a clock's period in ps in which everything settles.
// energy more --device D ...: "pipelined", or the clock cycles that a device with strobes takes beyond the two of a write.
// energy activity NETLIST.json CELLS.lib WAVES.vcd CYCLES --toggles FILE: how often each cell's pins change in the waves, as
//   lines "activity PIN CHANGES_PER_CYCLE"; the changes of each block's cells' outputs in FILE.
// energy collect DELAYS.json ROWS HALF KINDS: what was counted and what OpenSTA reported, as a row. KINDS has a line
//   "KIND CYCLES" for each kind of rows; beside it lie KIND.delayed.toggles, KIND.plain.watts and so on.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tb/cost/cost_row.h"
#include "tb/cost/delays.h"
#include "tb/device_arguments.h"
#include "tb/program.h"
#include "tb/usage_error.h"

namespace {

using namespace blysk;
using json = nlohmann::ordered_json;

/// Output pins of each cell of a Liberty file.
std::map<std::string, std::set<std::string>> output_pins(const std::string& path) {
  static const std::regex cell_line(R"(^\s*cell\s*\((\w+)\))");
  static const std::regex pin_line(R"(^\s*pin\s*\((\w+)\))");
  static const std::regex output_line(R"(^\s*direction\s*:\s*"?output)");
  std::map<std::string, std::set<std::string>> pins;
  std::string cell, pin;
  std::istringstream lines(cost::read_text(path));
  std::smatch found;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_search(line, found, cell_line)) {
      cell = found[1];
    } else if (std::regex_search(line, found, pin_line)) {
      pin = found[1];
    } else if (std::regex_search(line, output_line)) {
      pins[cell].insert(pin);
    }
  }
  if (pins.empty()) throw file_error(path, 0, "has no output pin, expected a library of cells");
  return pins;
}

/// How often each net changes between 0 and 1, by its scope below the device and its name: "mul10/_12_".
std::map<std::string, long long> changes_of(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw file_error(path, 0, "cannot be read");
  std::map<std::string, std::vector<std::string>> names;  // by code
  std::vector<std::string> scope;
  std::string line;
  while (std::getline(file, line) && !line.starts_with("$enddefinitions")) {
    std::istringstream words(line);
    std::string word, kind, width, code, name;
    words >> word;
    if (word == "$scope") {
      words >> kind >> name;
      scope.push_back(name);
    } else if (word == "$upscope") {
      scope.pop_back();
    } else if (word == "$var") {
      words >> kind >> width >> code >> name;
      if (name.starts_with('\\')) name.erase(0, 1);
      std::string index;
      if (words >> index && index != "$end") name += index;
      // The bench, the wrapper and the device come first.
      constexpr std::size_t kAbove = 3;
      std::string whole;
      for (std::size_t i = kAbove; i < scope.size(); ++i) whole += scope[i] + "/";
      if (scope.size() >= kAbove) names[code].push_back(whole + name);
    }
  }
  if (names.empty()) throw file_error(path, 0, "names no net, expected the waves of the mapped netlist");
  struct state {
    char value = 'x';
    long long changes = 0;
  };
  std::map<std::string, state> nets;
  for (const auto& [code, of] : names) nets[code];
  while (std::getline(file, line) && !line.starts_with("$dumpoff")) {
    if (line.empty() || (line.front() != '0' && line.front() != '1' && line.front() != 'x')) continue;
    const auto found = nets.find(line.substr(1));
    if (found == nets.end()) continue;
    state& net = found->second;
    if (net.value != 'x' && line.front() != 'x' && net.value != line.front()) ++net.changes;
    net.value = line.front();
  }
  std::map<std::string, long long> changes;
  for (const auto& [code, of] : names) {
    for (const std::string& name : of) changes[name] = nets[code].changes;
  }
  return changes;
}

void activity(const std::string& netlist_path, const std::string& library, const std::string& waves,
              double cycles, const std::string& toggles_path) {
  const auto outputs = output_pins(library);
  const auto changes = changes_of(waves);
  const json modules = cost::parse_json(netlist_path, cost::read_text(netlist_path)).at("modules");
  const json* top = nullptr;
  for (const auto& [name, module] : modules.items()) {
    for (const auto& [instance, cell] : module.at("cells").items()) {
      if (modules.contains(cell.at("type").get<std::string>())) top = &module;
    }
  }
  if (top == nullptr) throw file_error(netlist_path, 0, "has no module of blocks");
  std::map<std::string, long long> per_block;
  long long drivers = 0;
  for (const auto& [block, instance] : top->at("cells").items()) {
    const json& module = modules.at(instance.at("type").get<std::string>());
    std::map<int, std::string> names;
    for (const auto& [name, what] : module.at("netnames").items()) {
      const json& bits = what.at("bits");
      for (std::size_t i = 0; i < bits.size(); ++i) {
        const std::string whole = bits.size() == 1 ? name : fmt::format("{}[{}]", name, i);
        if (bits[i].is_number() && changes.contains(block + "/" + whole)) names[bits[i].get<int>()] = whole;
      }
    }
    long long& sum = per_block[block];
    for (const auto& [cell, what] : module.at("cells").items()) {
      const std::set<std::string>& driven = outputs.at(what.at("type").get<std::string>());
      for (const auto& [pin, bits] : what.at("connections").items()) {
        if (bits.empty() || !bits.at(0).is_number()) continue;  // nothing, or a constant
        const auto net = names.find(bits.at(0).get<int>());
        if (net == names.end())
          throw file_error(waves, 0, fmt::format("lacks the net at {}/{}/{}", block, cell, pin));
        const long long count = changes.at(block + "/" + net->second);
        if (driven.contains(pin)) {
          sum += count;
          ++drivers;
        }
        // OpenSTA takes an activity of 0 for none that is given.
        constexpr double kNone = 1e-9;
        fmt::print("activity {}/{}/{} {:.9f}\n", block, cell, pin,
                   std::max(static_cast<double>(count) / cycles, kNone));
      }
    }
  }
  if (drivers == 0) throw file_error(netlist_path, 0, "has no cells");
  std::string text;
  for (const auto& [block, sum] : per_block) text += fmt::format("{} {}\n", block, sum);
  cost::write_text(toggles_path, text);
}

/// Changes of each block's cells.
std::map<std::string, long long> read_toggles(const std::string& path) {
  std::map<std::string, long long> toggles;
  std::istringstream lines(cost::read_text(path));
  std::string block;
  for (long long count = 0; lines >> block >> count;) toggles[block] = count;
  return toggles;
}

/// What each block's cells take within and to drive their outputs, W. Leakage is left out: it goes with time, not with results.
std::map<std::string, double> read_watts(const std::string& path) {
  std::map<std::string, double> watts;
  std::istringstream lines(cost::read_text(path));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    double internal = 0, switching = 0, leakage = 0, total = 0;
    std::string name;
    if (!(words >> internal >> switching >> leakage >> total >> name)) continue;
    const std::size_t slash = name.find('/');
    if (slash != std::string::npos) watts[name.substr(0, slash)] += internal + switching;
  }
  if (watts.empty()) throw file_error(path, 0, "has no watts, expected a report of OpenSTA");
  return watts;
}

double rounded(double value) {
  return std::round(value * 1000) / 1000;
}

void collect(const std::string& delays_path, int rows, double half_ps, const std::string& kinds_path) {
  const json delays = cost::parse_json(delays_path, cost::read_text(delays_path));
  json row;
  for (const char* key : {"device", "format", "options", "digest", "tools", "script"})
    row[key] = delays.at(key);
  row["results"] = rows;
  std::istringstream kinds(cost::read_text(kinds_path));
  std::string kind;
  for (int cycles = 0; kinds >> kind >> cycles;) {
    json& to = row["stimuli"][kind];
    to["cycles"] = cycles;
    json blocks = json::object();
    for (const char* run : {"delayed", "plain"}) {
      const std::string key = run == std::string("delayed") ? "with_delays" : "without";
      const auto toggles = read_toggles(fmt::format("{}.{}.toggles", kind, run));
      const auto watts = read_watts(fmt::format("{}.{}.watts", kind, run));
      const double pj_per_w = 2 * half_ps * cycles / rows;  // W times ps
      double sum_toggles = 0, sum_pj = 0;
      for (const auto& [block, count] : toggles) {
        const auto found = watts.find(block);
        const double pj = found == watts.end() ? 0 : found->second * pj_per_w;
        const double each = static_cast<double>(count) / rows;
        sum_toggles += each;
        sum_pj += pj;
        blocks[block][key] = {{"toggles", rounded(each)}, {"pj", rounded(pj)}};
      }
      to[key] = {{"toggles", rounded(sum_toggles)}, {"pj", rounded(sum_pj)}};
    }
    to["blocks"] = blocks;
  }
  fmt::print("{}", cost::stored_text(row));
}

std::string more(const selection& asked) {
  const std::vector<port> ports = asked.of().ports(asked);
  if (protocol_of(ports) == protocol::handshake) {
    if (asked.of().cycles_per_row(asked) != 1)
      throw std::invalid_argument(asked.text() + " takes no row in each cycle, expected a pipelined device");
    return "pipelined";
  }
  return fmt::format("{}", ports.at(find_role(ports, port::role::valid)).settling_cycles);
}

}  // namespace

int main(int argc, char** argv) {
  std::string delays, netlist, library, waves, toggles, kinds;
  double cycles = 0, half = 0;
  int rows = 0;
  asked_device asked;
  CLI::App *halves = nullptr, *mores = nullptr, *counts = nullptr, *collects = nullptr;
  return run_program(
      argc, argv, "Counts the changes of a mapped netlist and collects the energy of its cells",
      [&](CLI::App& program) {
        program.require_subcommand(1);
        halves =
            program.add_subcommand("half", "print half a clock's period in ps in which everything settles");
        mores = program.add_subcommand("more", "print how a device takes its rows");
        add_device_arguments(*mores, asked, purpose::hardware);
        counts = program.add_subcommand("activity", "count the changes of each cell's pins");
        counts->add_option("NETLIST", netlist, "that Yosys wrote as JSON")->required();
        counts->add_option("LIBRARY", library, "of the cells")->required();
        counts->add_option("WAVES", waves, "of the nets of its blocks")->required();
        counts->add_option("CYCLES", cycles, "of the clock in the waves")->required();
        counts->add_option("--toggles", toggles, "file for the changes of each block")->required();
        collects = program.add_subcommand("collect", "make a row");
        for (CLI::App* each : {halves, collects})
          each->add_option("DELAYS", delays, "of scripts/synth --delays")->required();
        collects->add_option("ROWS", rows, "results that were recorded")->required();
        collects->add_option("HALF", half, "half the clock's period in ps")->required();
        collects->add_option("KINDS", kinds, "kinds of rows and their cycles")->required();
      },
      [&] {
        if (halves->parsed()) {
          constexpr int kMore = 1000;
          fmt::print("{}\n", cost::parse_delays(delays, cost::read_text(delays)).bound_ps + kMore);
        } else if (mores->parsed()) {
          fmt::print("{}\n", more(asked.choose()));
        } else if (counts->parsed()) {
          activity(netlist, library, waves, cycles, toggles);
        } else {
          collect(delays, rows, half, kinds);
        }
        return 0;
      });
}
