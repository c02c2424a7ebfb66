// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tb/cost/cost_row.h"
#include "tb/cost/delays.h"
#include "tb/usage_error.h"

namespace blysk::cost {
namespace {

using json = nlohmann::ordered_json;

enum edge : std::size_t { rise, fall };

/// Which edge of an input an arc's edge of the output follows.
enum class sense { positive, negative, none };

/// From an input of a cell to its output, by the output's edge, ps.
struct arc {
  std::string from, to;
  std::array<int, 2> ps;
  sense follows;
};

/// The text after `key` between quotes or up to a bracket or semicolon, without blanks.
std::string value_after(const std::string& line, const std::string& key) {
  std::string value = line.substr(line.find(key) + key.size());
  std::erase_if(value, [](char of) { return of == '"' || of == ' ' || of == ':' || of == '('; });
  return value.substr(0, value.find_first_of(");{"));
}

/// The arcs' senses by cell, input and output. Reads libraries that have one attribute a line.
std::map<std::array<std::string, 3>, sense> read_senses(const std::string& path) {
  std::map<std::array<std::string, 3>, sense> senses;
  std::istringstream lines(read_text(path));
  std::string line, cell, pin, related;
  while (std::getline(lines, line)) {
    const std::size_t first = line.find_first_not_of(' ');
    if (first == std::string::npos) continue;
    const std::string_view word = std::string_view(line).substr(first);
    if (word.starts_with("cell (") || word.starts_with("cell(")) cell = value_after(line, "cell");
    if (word.starts_with("pin(") || word.starts_with("pin (")) pin = value_after(line, "pin");
    if (word.starts_with("related_pin")) related = value_after(line, "related_pin");
    if (!word.starts_with("timing_sense")) continue;
    const std::string kind = value_after(line, "timing_sense");
    sense& of = senses
                    .try_emplace({cell, related, pin}, kind == "positive_unate"   ? sense::positive
                                                       : kind == "negative_unate" ? sense::negative
                                                                                  : sense::none)
                    .first->second;
    if ((kind == "positive_unate") != (of == sense::positive) ||
        (kind == "negative_unate") != (of == sense::negative))
      of = sense::none;
  }
  if (senses.empty()) throw file_error(path, 0, "has no timing_sense, expected a library of cells");
  return senses;
}

/// "0.197" of "(0.124::0.197)": the larger end, ps.
int worst_ps(const std::string& path, std::size_t line, std::string_view text) {
  double worst = -1;
  while (!text.empty()) {
    const std::size_t start = text.find_first_of("0123456789.");
    if (start == std::string_view::npos) break;
    double value = 0;
    const char* const first = text.data() + start;
    const auto [end, error] = std::from_chars(first, text.data() + text.size(), value);
    if (error != std::errc{}) break;
    worst = std::max(worst, value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  if (worst < 0) throw file_error(path, line, "has an IOPATH without a delay, expected (min::max)");
  return static_cast<int>(std::lround(worst * 1000));
}

/// The cells' arcs by instance, "mul6._0660_".
std::map<std::string, std::vector<arc>> read_arcs(const std::string& path,
                                                  const std::map<std::array<std::string, 3>, sense>& senses) {
  std::map<std::string, std::vector<arc>> arcs;
  std::istringstream lines(read_text(path));
  std::string line, cell, instance;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "(CELLTYPE") cell = value_after(line, "(CELLTYPE");
    if (word == "(INSTANCE") instance = value_after(line, "(INSTANCE");
    if (word == "(TIMESCALE" && line.find("1ns") == std::string::npos)
      throw file_error(path, number, "counts in another unit, expected a TIMESCALE of 1ns");
    if (word != "(IOPATH") continue;
    std::string from, to, first, second;
    words >> from >> to >> first >> second;
    if (second.empty() || second == ")") second = first;
    const auto known = senses.find({cell, from, to});
    // The first delay is that of the output's rising edge.
    arcs[instance].push_back({from,
                              to,
                              {worst_ps(path, number, first), worst_ps(path, number, second)},
                              known == senses.end() ? sense::none : known->second});
  }
  if (arcs.empty()) throw file_error(path, 0, "has no IOPATH, expected an SDF file of OpenSTA");
  return arcs;
}

/// A net of a block, or a constant.
using net = std::string;

net net_of(const json& bit) {
  return bit.is_string() ? bit.get<std::string>() : fmt::format("{}", bit.get<std::int64_t>());
}

struct placed_arc {
  net from, to;
  std::array<int, 2> ps;
  sense follows;
};

/// "a_i[3]" is bit 3 of "a_i"; "clk" is bit 0 of itself.
std::pair<std::string, int> split(const std::string& port) {
  const std::size_t bracket = port.find('[');
  if (bracket == std::string::npos) return {port, 0};
  return {port.substr(0, bracket), std::stoi(port.substr(bracket + 1))};
}

/// The arcs of a block's cells so that each comes after those that end where it starts.
std::vector<placed_arc> in_order(const std::string& name, std::vector<placed_arc> arcs) {
  std::map<net, std::vector<std::size_t>> leaving;
  std::map<net, int> arriving;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    leaving[arcs[i].from].push_back(i);
    ++arriving[arcs[i].to];
  }
  std::vector<net> ready;
  for (const auto& [from, unused] : leaving) {
    if (!arriving.contains(from)) ready.push_back(from);
  }
  std::vector<placed_arc> ordered;
  while (!ready.empty()) {
    const net from = ready.back();
    ready.pop_back();
    const auto found = leaving.find(from);
    if (found == leaving.end()) continue;
    for (const std::size_t i : found->second) {
      ordered.push_back(arcs[i]);
      if (--arriving[arcs[i].to] == 0) ready.push_back(arcs[i].to);
    }
  }
  if (ordered.size() != arcs.size()) throw std::runtime_error("the cells of " + name + " are in a loop");
  return ordered;
}

/// Ports of one direction of a block: the nets of their bits, by name; names in the netlist's order.
struct split_ports {
  std::map<std::string, std::map<int, net>> nets;
  std::vector<std::string> order;

  void add(const std::string& port, const net& wire) {
    const auto [base, bit] = split(port);
    if (!nets.contains(base)) order.push_back(base);
    nets[base][bit] = wire;
  }
  std::vector<timed_pin> pins() const {
    std::vector<timed_pin> all;
    for (const std::string& name : order) all.push_back({name, static_cast<int>(nets.at(name).size())});
    return all;
  }
};

/// The arcs of the cells of a block, in_order().
std::vector<placed_arc> place_arcs(const std::string& name, const json& cells,
                                   const std::map<std::string, std::vector<arc>>& arcs) {
  std::vector<placed_arc> placed;
  for (const auto& [cell, what] : cells.items()) {
    const auto found = arcs.find(name + "." + cell);
    if (found == arcs.end())
      throw std::runtime_error(fmt::format("cell {}.{} has no delays in the SDF file", name, cell));
    const json& pins = what.at("connections");
    for (const arc& each : found->second) {
      placed.push_back(
          {net_of(pins.at(each.from).at(0)), net_of(pins.at(each.to).at(0)), each.ps, each.follows});
    }
  }
  return in_order(name, std::move(placed));
}

/// When the edges of each net that a change of `source` reaches are over, ps.
/// \param arcs  in_order()
std::map<net, std::array<int, 2>> arrivals(const net& source, const std::vector<placed_arc>& arcs) {
  std::map<net, std::array<int, 2>> arrival{{source, {0, 0}}};
  for (const placed_arc& each : arcs) {
    const auto from = arrival.find(each.from);
    if (from == arrival.end()) continue;
    const auto [in_rise, in_fall] = from->second;
    const int any = std::max(in_rise, in_fall);
    std::array<int, 2>& to =
        arrival.try_emplace(each.to, std::array<int, 2>{block_delays::kNoPath, block_delays::kNoPath})
            .first->second;
    const int before_rise = each.follows == sense::positive   ? in_rise
                            : each.follows == sense::negative ? in_fall
                                                              : any;
    const int before_fall = each.follows == sense::positive   ? in_fall
                            : each.follows == sense::negative ? in_rise
                                                              : any;
    to[rise] = std::max(to[rise], before_rise + each.ps[rise]);
    to[fall] = std::max(to[fall], before_fall + each.ps[fall]);
  }
  return arrival;
}

block_delays measure_block(const std::string& name, const json& module,
                           const std::map<std::string, std::vector<arc>>& arcs) {
  split_ports inputs, outputs;
  for (const auto& [port, what] : module.at("ports").items())
    (what.at("direction") == "output" ? outputs : inputs).add(port, net_of(what.at("bits").at(0)));
  std::vector<net> sources;
  for (const std::string& input : inputs.order) {
    for (const auto& [bit, wire] : inputs.nets.at(input)) sources.push_back(wire);
  }
  const std::vector<placed_arc> placed = place_arcs(name, module.at("cells"), arcs);
  block_delays result;
  result.block = name;
  result.inputs = inputs.pins();
  result.outputs = outputs.pins();
  for (const timed_pin& output : result.outputs) {
    result.ps.emplace_back(static_cast<std::size_t>(output.width),
                           std::vector<int>(sources.size(), block_delays::kNoPath));
  }
  for (std::size_t source = 0; source < sources.size(); ++source) {
    const auto arrival = arrivals(sources[source], placed);
    for (std::size_t i = 0; i < outputs.order.size(); ++i) {
      std::size_t bit = 0;
      for (const auto& [number, wire] : outputs.nets.at(outputs.order[i])) {
        const auto found = arrival.find(wire);
        if (found != arrival.end())
          result.ps[i][bit][source] = std::max(found->second[rise], found->second[fall]);
        ++bit;
      }
    }
  }
  return result;
}

/// The blocks on the path of a report_checks, and the time in each.
std::vector<path_step> read_path(const std::string& path) {
  const std::string text = read_text(path);
  // OpenSTA goes on after an error, without what it could not read.
  if (text.find("Error") != std::string::npos || text.find("error") != std::string::npos)
    throw file_error(path, 0, "reports an error of OpenSTA, expected none");
  std::vector<path_step> steps;
  std::istringstream lines(text);
  std::string line;
  int last = 0;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    double delay = 0, time = 0;
    std::string direction, pin;
    if (line.find("data arrival time") != std::string::npos) break;
    if (!(words >> delay >> time >> direction >> pin) || (direction != "^" && direction != "v")) continue;
    const std::size_t slash = pin.find('/');
    if (slash == std::string::npos) continue;  // the output port
    const std::string block = pin.substr(0, slash);
    if (steps.empty() || steps.back().block != block) steps.push_back({block, 0});
    const int now = static_cast<int>(std::lround(time * 1000));
    steps.back().ps += now - last;
    last = now;
  }
  if (steps.empty()) throw file_error(path, 0, "has no path, expected what report_checks of OpenSTA prints");
  return steps;
}

/// The longest path from the clock through the blocks.
/// \param cells  the top module's
int longest_path(const device_delays& of, const json& cells, const net& clock, bool is_by_bit) {
  std::vector<placed_arc> arcs;
  for (const block_delays& block : of.blocks) {
    const json& pins = cells.at(block.block).at("connections");
    const auto nets_of = [&](const timed_pin& pin) {
      std::vector<net> nets;
      for (int bit = 0; bit < pin.width; ++bit) {
        const std::string name = fmt::format("{}[{}]", pin.name, bit);
        nets.push_back(net_of(pins.at(pins.contains(name) ? name : pin.name).at(0)));
      }
      return nets;
    };
    std::vector<net> from;
    for (const timed_pin& pin : block.inputs) {
      for (const net& each : nets_of(pin)) from.push_back(each);
    }
    int worst = 0;
    for (const auto& output : block.ps) {
      for (const auto& row : output) worst = std::max(worst, std::ranges::max(row));
    }
    for (std::size_t i = 0; i < block.outputs.size(); ++i) {
      const std::vector<net> to = nets_of(block.outputs[i]);
      for (std::size_t bit = 0; bit < to.size(); ++bit) {
        for (std::size_t source = 0; source < from.size(); ++source) {
          const int ps = block.ps[i][bit][source];
          if (ps == block_delays::kNoPath) continue;
          const int taken = is_by_bit ? ps : worst;
          arcs.push_back({from[source], to[bit], {taken, taken}, sense::none});
        }
      }
    }
  }
  std::map<net, int> arrival{{clock, 0}};
  int longest = 0;
  for (const placed_arc& each : in_order("the device", std::move(arcs))) {
    const auto from = arrival.find(each.from);
    if (from == arrival.end()) continue;
    int& to = arrival[each.to];
    to = std::max(to, from->second + each.ps[rise]);
    longest = std::max(longest, to);
  }
  return longest;
}

}  // namespace

void measure(const mapped_files& files, const std::string& top, const std::string& clock_name,
             device_delays& to) {
  to.path = read_path(files.path);
  const auto arcs = read_arcs(files.sdf, read_senses(files.library));
  const json netlist = parse_json(files.netlist, read_text(files.netlist));
  try {
    const json& modules = netlist.at("modules");
    for (const auto& [name, cell] : modules.at(top).at("cells").items()) {
      const std::string kind = cell.at("type");
      if (!modules.contains(kind))
        throw std::runtime_error(fmt::format(
            "cell {} lies between the blocks of {}, expected cells within blocks alone", name, top));
      to.blocks.push_back(measure_block(name, modules.at(kind), arcs));
    }
    const json& cells = modules.at(top).at("cells");
    const net clock = net_of(modules.at(top).at("ports").at(clock_name).at("bits").at(0));
    to.bound_ps = longest_path(to, cells, clock, true);
    to.blocks_bound_ps = longest_path(to, cells, clock, false);
  } catch (const json::exception&) {
    throw file_error(files.netlist, 0, "is no netlist, expected what write_json of Yosys writes");
  }
}

}  // namespace blysk::cost
