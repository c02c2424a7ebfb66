// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "tb/cli/engines.h"
#include "tb/cli/verbs.h"
#include "tb/device.h"
#include "tb/golden/registry.h"

namespace blysk::cli {
namespace {

nlohmann::ordered_json listing() {
  nlohmann::ordered_json json;
  json["devices"] = device_names;
  json["formats"] = format_names;
  json["coefficients"] = coefficient_names;
  json["engines"] = engine_names;
  json["models"] = nlohmann::ordered_json::array();
  for (const golden::model& model : golden::models()) {
    json["models"].push_back({{"name", model.name},
                              {"header", model.header},
                              {"formula", model.formula},
                              {"source", model.source}});
  }
  return json;
}

void print(const nlohmann::ordered_json& json) {
  for (const char* key : {"devices", "formats", "coefficients", "engines"}) {
    fmt::print("{:<13}", key);
    for (const auto& name : json[key]) fmt::print(" {}", name.get<std::string>());
    fmt::print("\n");
  }
  fmt::print("models\n");
  for (const auto& model : json["models"]) {
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
