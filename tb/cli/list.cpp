// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "tb/cli/engines.h"
#include "tb/cli/verbs.h"
#include "tb/device.h"
#include "tb/golden/registry.h"

namespace blysk::cli {
namespace {

nlohmann::ordered_json listing() {
  using json = nlohmann::ordered_json;
  json listed;
  listed["devices"] = json::array();
  for (const device* each : devices()) {
    const std::vector<port> ports = each->ports(choose(each->name(), std::string(format_names[0])));
    const auto columns = [&](port::role role) {
      json names = json::array();
      for (const port& of : of_role(ports, role)) names.push_back(of.column);
      return names;
    };
    json rom_bits;
    for (const auto format : format_names) {
      const selection asked = choose(each->name(), std::string(format));
      rom_bits[std::string(format)] = each->rom_bits(asked);
    }
    json options = json::array();
    for (const option& of : each->options()) {
      options.push_back({{"name", of.name},
                         {"help", of.help},
                         {"values", of.values},
                         {"default", of.preset},
                         {"golden_values", of.formula_values},
                         {"hardware_only", of.is_wired}});
    }
    listed["devices"].push_back({{"name", each->name()},
                                 {"title", each->title()},
                                 {"source", each->source()},
                                 {"stimulus", columns(port::role::data)},
                                 {"results", columns(port::role::result)},
                                 {"rom_bits", rom_bits},
                                 {"options", options}});
  }
  listed["formats"] = format_names;
  listed["engines"] = json::array();
  for (const engine_choice& each : engine_choices()) listed["engines"].push_back(each.name);
  listed["models"] = json::array();
  for (const golden::model& model : golden::models()) {
    listed["models"].push_back({{"name", model.name},
                                {"header", model.header},
                                {"formula", model.formula},
                                {"source", model.source}});
  }
  return listed;
}

std::string joined(const nlohmann::ordered_json& names, std::string_view separator) {
  return fmt::format("{}", fmt::join(names.get<std::vector<std::string>>(), separator));
}

void print(const nlohmann::ordered_json& listed) {
  fmt::print("devices\n");
  for (const auto& each : listed["devices"]) {
    fmt::print("  {:<24} {}\n", each["name"].get<std::string>(), each["title"].get<std::string>());
    fmt::print("  {:<24} {}; {} to {}\n", "", each["source"].get<std::string>(),
               joined(each["stimulus"], ","), joined(each["results"], ","));
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
  verb->add_flag("--json", *as_json, "print JSON");
  verb->footer(
      "Examples:\n"
      "  blysk list\n"
      "  blysk list --json");
  verb->callback([as_json] {
    const auto json = listing();
    if (*as_json) {
      fmt::print("{}\n", json.dump(2));
    } else {
      print(json);
    }
  });
}

}  // namespace blysk::cli
