// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "tb/cli/engines.h"
#include "tb/cli/verbs.h"
#include "tb/cost/cost_row.h"
#include "tb/cost/errors.h"
#include "tb/cost/measured.h"
#include "tb/device.h"
#include "tb/golden/registry.h"
#include "tb/netlist/elaborated.h"

namespace blysk::cli {
namespace {

using json = nlohmann::ordered_json;

constexpr std::string_view kEpicentre = "epicentre-0.60";  // domains of `explore`
constexpr std::string_view kWhole = "whole";
const std::string kTableFormat = "q16";  // of the table for people; JSON has all formats

json columns_of(const std::vector<port>& ports, port::role role) {
  json names = json::array();
  for (const port& of : of_role(ports, role)) names.push_back(of.column);
  return names;
}

json options_of(const device& of) {
  json options = json::array();
  for (const option& each : of.options()) {
    options.push_back({{"name", each.name},
                       {"help", each.help},
                       {"values", each.values},
                       {"default", each.preset},
                       {"golden_values", each.formula_values},
                       {"hardware_only", each.is_wired}});
  }
  return options;
}

/// The leaf blocks in the order of the netlist. Several devices may be elaborated, as long as none is simulated.
json blocks_of(const selection& asked) {
  json blocks = json::array();
  const auto elaborated = asked.of().elaborate(asked, 0);
  for (const sc_core::sc_module* module : elaborated->parts().modules()) {
    const std::string& words = elaborated->parts().find(*module)->words();
    blocks.push_back({{"instance", elaborated->path_of(*module)}, {"is", words.substr(0, words.find(':'))}});
  }
  return blocks;
}

/// Of the measured rows of each format that has one, with the keys and values that `explore` has.
json errors_of(const device& of) {
  json rows = json::array();
  for (const auto format : format_names) {
    selection asked = choose(of.name(), std::string(format));
    if (auto other = of.computes_as(asked)) asked = *other;
    const std::string path = cost::row_path("errors", asked);
    const std::optional<std::string> text = cost::embedded_text(path);
    if (!text) continue;
    const cost::error_table table = cost::parse_errors(path, json::parse(*text).at("domains"));
    const auto in = [&](cost::domain where) { return table[static_cast<std::size_t>(where)]; };
    const cost::errors whole = in(cost::domain::whole);
    rows.push_back({{"format", format},
                    {"domain", kEpicentre},
                    {"max_rel_err", in(cost::domain::epicentre_060).max_rel_err}});
    rows.push_back({{"format", format},
                    {"domain", kWhole},
                    {"max_abs_err", whole.max_abs_err},
                    {"n", whole.max_abs_n},
                    {"cos", whole.max_abs_cos}});
  }
  return rows;
}

json device_listing(const device& of) {
  json rom_bits;
  for (const auto format : format_names)
    rom_bits[std::string(format)] = of.rom_bits(choose(of.name(), std::string(format)));
  const selection asked = choose(of.name(), kTableFormat);
  const std::vector<port> ports = of.ports(asked);
  json results = columns_of(ports, port::role::result);
  json aliases = json::object();
  for (const device_alias& each : of.aliases()) aliases[each.name] = each.options;
  const std::optional<int> latency = of.latency_cycles(asked);
  if (of.draws_lines()) results.insert(results.begin(), {"line", "pixel"});
  return {{"name", of.name()},
          {"aliases", aliases},
          {"title", of.title()},
          {"source", of.source()},
          {"figure", of.figure()},
          {"good_for", of.good_for()},
          {"stimulus", columns_of(ports, port::role::data)},
          {"results", results},
          {"blocks", blocks_of(asked)},
          {"rom_bits", rom_bits},
          {"latency_cycles", latency ? json(*latency) : json(nullptr)},
          {"cycles_per_row", latency ? json(of.cycles_per_row(asked)) : json(nullptr)},
          {"errors", errors_of(of)},
          {"options", options_of(of)}};
}

json listing() {
  json listed;
  listed["devices"] = json::array();
  for (const device* each : devices()) listed["devices"].push_back(device_listing(*each));
  listed["formats"] = format_names;
  listed["engines"] = json::array();
  for (const engine_choice& each : engine_choices()) listed["engines"].push_back(each.name);
  listed["engines"].push_back(kTimedEngine);
  listed["models"] = json::array();
  for (const golden::model& model : golden::models()) {
    listed["models"].push_back({{"name", model.name},
                                {"header", model.header},
                                {"formula", model.formula},
                                {"source", model.source}});
  }
  return listed;
}

std::string joined(const json& names, std::string_view separator) {
  return fmt::format("{}", fmt::join(names.get<std::vector<std::string>>(), separator));
}

/// The table format's row of the domain: "3.2 %" if relative, "0.28 (n = 969)" if absolute; "-" if there is none.
std::string error_text(const json& device, std::string_view domain) {
  for (const auto& row : device["errors"]) {
    if (row["format"] != kTableFormat || row["domain"] != domain) continue;
    if (row.contains("max_rel_err")) return fmt::format("{:.2g} %", 100 * row["max_rel_err"].get<double>());
    return fmt::format("{:.2g} (n = {})", row["max_abs_err"].get<double>(), row["n"].get<int>());
  }
  return "-";
}

std::string number_text(const json& value) {
  return value.is_null() ? "-" : std::to_string(value.get<std::int64_t>());
}

std::string cycles_text(const json& device) {
  const json& row = device["cycles_per_row"];
  return number_text(device["latency_cycles"]) + (row.is_number() && row == 1 ? ", one a cycle" : "");
}

/// The devices as rows of a table, its head first.
std::vector<std::vector<std::string>> device_table(const json& listed) {
  std::vector<std::vector<std::string>> rows{{"device", "source", "blocks", "ROM bits", "cycles",
                                              "error, epicentre", "error, whole range", "good for"}};
  for (const auto& each : listed["devices"]) {
    rows.push_back({each["name"].get<std::string>(),
                    each["source"].get<std::string>() + ", " + each["figure"].get<std::string>(),
                    std::to_string(each["blocks"].size()), number_text(each["rom_bits"][kTableFormat]),
                    cycles_text(each), error_text(each, kEpicentre), error_text(each, kWhole),
                    each["good_for"].get<std::string>()});
  }
  return rows;
}

void print_markdown(const json& listed) {
  bool is_head = true;
  for (const std::vector<std::string>& row : device_table(listed)) {
    const std::string first =
        is_head ? row.front() : fmt::format("[{}](docs/devices/{}.md)", row.front(), row.front());
    fmt::print("| {} | {} |\n", first, fmt::join(row.begin() + 1, row.end(), " | "));
    if (is_head) fmt::print("|{}\n", fmt::join(std::vector<std::string>(row.size(), "---|"), ""));
    is_head = false;
  }
}

void print(const json& listed) {
  fmt::print(
      "devices, in format {}; errors against cos^n: relative where cos^n >= 0.6, absolute over the range\n",
      kTableFormat);
  const auto rows = device_table(listed);
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  for (const auto& row : rows) {
    fmt::print(" ");
    for (std::size_t i = 0; i < row.size(); ++i) fmt::print(" {:<{}}", row[i], widths[i]);
    fmt::print("\n");
  }
  fmt::print("options\n");
  for (const auto& each : listed["devices"]) {
    fmt::print("  {:<24} {}; {} to {}\n", each["name"].get<std::string>(), each["title"].get<std::string>(),
               joined(each["stimulus"], ","), joined(each["results"], ","));
    for (const auto& [alias, fixed] : each["aliases"].items()) {
      std::string words;
      for (const auto& [name, value] : fixed.items())
        words += fmt::format(" --{} {}", name, value.get<std::string>());
      fmt::print("  {:<24} also {}:{}\n", "", alias, words);
    }
    for (const auto& of : each["options"]) {
      const std::string values = joined(of["values"], ", ");
      const std::string golden = joined(of["golden_values"], ", ");
      fmt::print("  {:<24} --{}{}{}: {}\n", "", of["name"].get<std::string>(),
                 values.empty() || values == "off, on" ? "" : fmt::format(" [{}]", values),
                 golden.empty() ? "" : fmt::format(", engine golden also [{}]", golden),
                 of["help"].get<std::string>());
    }
  }
  for (const char* key : {"formats", "engines"}) fmt::print("{:<13} {}\n", key, joined(listed[key], " "));
  fmt::print("models\n");
  for (const auto& model : listed["models"]) {
    fmt::print("  {:<25} {:<8} {}   {}\n", model["name"].get<std::string>(),
               model["header"].get<std::string>(), model["formula"].get<std::string>(),
               model["source"].get<std::string>());
  }
}

}  // namespace

void add_list(CLI::App& program) {
  auto* verb = program.add_subcommand("list", "Name devices, formats, engines and golden models");
  auto as_json = std::make_shared<bool>(false);
  auto as_markdown = std::make_shared<bool>(false);
  verb->add_flag("--json", *as_json, "print JSON");
  verb->add_flag("--markdown", *as_markdown, "print the table of devices, as README has it")
      ->excludes("--json");
  verb->footer(
      "Examples:\n"
      "  blysk list\n"
      "  blysk list --json");
  verb->callback([as_json, as_markdown] {
    const json listed = listing();
    if (*as_json) {
      fmt::print("{}\n", listed.dump(2));
    } else if (*as_markdown) {
      print_markdown(listed);
    } else {
      print(listed);
    }
  });
}

}  // namespace blysk::cli
