// SPDX-License-Identifier: Apache-2.0
// `blysk list`, for people and for programs.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "tb/catch.h"
#include "tb/cli/test/program.h"

namespace {

TEST_CASE("list names what there is, for people and for programs", "[cli]") {
  const scratch folder;
  const auto json = nlohmann::json::parse(run_blysk(folder, "list --json").out);
  const std::string text = run_blysk(folder, "list").out;
  CHECK(json["models"].size() >= 16);
  for (const auto& model : json["models"])
    CHECK(text.find(model["name"].get<std::string>()) != std::string::npos);
  // What an option takes beside engine golden, and what that engine alone takes.
  CHECK(text.find("--coefficient [derived, published], engine golden also [exact]: ") != std::string::npos);
  CHECK(run_blysk(folder, "export --help").out.find("[derived]: derived, published (of " + kDevice) !=
        std::string::npos);
  CHECK(run_blysk(folder, "simulate --help")
            .out.find("derived, published; engine golden also exact (of " + kDevice) != std::string::npos);
  for (const char* engine : {"golden", "bit", "systemc", "verilator", "timed"}) {
    CHECK(std::count(json["engines"].begin(), json["engines"].end(), engine) == 1);
  }
}

TEST_CASE("list says of each device what a user chooses it by", "[cli]") {
  const scratch folder;
  const auto json = nlohmann::json::parse(run_blysk(folder, "list --json").out);
  const std::string text = run_blysk(folder, "list").out;
  const std::string markdown = run_blysk(folder, "list --markdown").out;
  CHECK(std::count(markdown.begin(), markdown.end(), '\n') ==
        static_cast<std::ptrdiff_t>(json["devices"].size()) + 2);
  bool has_errors = false;
  int compared = 0;
  for (const auto& device : json["devices"]) {
    const auto name = device["name"].get<std::string>();
    CAPTURE(name);
    CHECK(markdown.find("| [" + name + "](docs/devices/" + name + ".md) | ") != std::string::npos);
    CHECK(fs::exists(BLYSK_ROOT "/docs/devices/" + name + ".md"));
    for (const char* key : {"title", "source", "figure", "good_for"}) {
      CAPTURE(key);
      CHECK_FALSE(device[key].get<std::string>().empty());
      CHECK(text.find(device[key].get<std::string>()) != std::string::npos);
    }
    CHECK_FALSE(device["blocks"].empty());
    for (const auto& block : device["blocks"]) {
      CHECK_FALSE(block["instance"].get<std::string>().empty());
      CHECK_FALSE(block["is"].get<std::string>().empty());
    }
    for (const auto& format : json["formats"]) CHECK(device["rom_bits"][format.get<std::string>()] >= 0);
    CHECK((device["latency_cycles"].is_null() || device["latency_cycles"] >= 1));
    for (const auto& row : device["errors"]) {
      has_errors = true;
      CAPTURE(row.dump());
      const bool is_whole = row["domain"] == "whole";
      CHECK((is_whole || row["domain"] == "epicentre-0.60"));
      const std::string key = is_whole ? "max_abs_err" : "max_rel_err";
      CHECK((row[key] >= 0 && row[key] < 1));
      if (is_whole) CHECK((row["n"] >= 1 && row["n"] <= 1000));
      // `explore` says the same of the format, and the table of the one it shows.
      if (row["format"] != "q8" && row["format"] != "q16") continue;
      const auto explored =
          nlohmann::json::parse(run_blysk(folder, "explore --json --device " + name + " --format " +
                                                      row["format"].get<std::string>() + " --domain " +
                                                      row["domain"].get<std::string>())
                                    .out);
      const auto same = std::find_if(explored.begin(), explored.end(),
                                     [](const auto& of) { return of["options"].empty(); });
      if (same == explored.end()) continue;  // a device that computes as another one, and has no cost
      CHECK((*same)[key] == row[key]);
      ++compared;
    }
    for (const auto& [alias, options] : device["aliases"].items()) {
      CAPTURE(alias);
      CHECK(text.find("also " + alias + ":") != std::string::npos);
    }
  }
  CHECK(has_errors);
  CHECK(compared > 20);
  CHECK(run_blysk(folder, "list --json --markdown").status == 2);
}

}  // namespace
