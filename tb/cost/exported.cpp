// SPDX-License-Identifier: Apache-2.0
// exported check|update DIRECTORY DEVICE FORMAT [--OPTION [VALUE]]...: the directory holds what the SystemC model with its
//   options exports, or is made so; one that is right already keeps its times.
// exported replay DIRECTORY DEVICE FORMAT [--OPTION [VALUE]]...: the same export, and below replay/ a run of the SystemC
//   device for a Verilog simulator to repeat.
// A process elaborates one device. Exit 1 if the directory holds anything else.
#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <string_view>

#include "tb/cost/annotated.h"
#include "tb/export/export.h"
#include "tb/export/replay.h"
#include "tb/program.h"

namespace {

using namespace blysk;
using namespace blysk::verilog;
namespace fs = std::filesystem;

files read_directory(const fs::path& directory) {
  files result;
  if (!fs::exists(directory)) return result;
  for (const auto& entry : fs::directory_iterator(directory)) {
    std::ifstream file(entry.path(), std::ios::binary);
    result[entry.path().filename()] = {std::istreambuf_iterator<char>(file), {}};
  }
  return result;
}

/// Prints how the directory differs from the export.
bool is_current(const files& exported, const files& there) {
  bool same = true;
  for (const auto& [name, text] : exported) {
    const auto found = there.find(name);
    if (found != there.end() && found->second == text) continue;
    fmt::print("{}: {}\n", name, found == there.end() ? "missing" : "differs");
    same = false;
  }
  for (const auto& [name, text] : there) {
    if (exported.contains(name)) continue;
    fmt::print("{}: not exported\n", name);
    same = false;
  }
  return same;
}

int run(const std::string& action, const fs::path& directory, const selection& asked) {
  const auto device = asked.of().elaborate(asked, 0);
  const files exported = cost::annotated_export(*device, asked, asked.top_name());
  if (action == "check") return is_current(exported, read_directory(directory)) ? 0 : 1;
  if (action == "update") {
    if (read_directory(directory) == exported) return 0;
    fs::remove_all(directory);
  }
  fs::create_directories(directory);
  write_files(exported, directory);
  if (action == "replay") {
    constexpr int kCycles = 2000;
    fs::create_directories(directory / "replay");
    write_replay(*device, asked.top_name(), kCycles, directory / "replay");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::string action, directory;
  device_arguments arguments;
  return run_program(
      argc, argv, "Compares a directory with what the SystemC model exports, or writes it",
      [&](CLI::App& program) {
        program.add_option("ACTION", action, "check, update or replay")
            ->required()
            ->check(CLI::IsMember({"check", "update", "replay"}));
        program.add_option("DIRECTORY", directory, "of the Verilog")->required();
        arguments.add_to(program);
        arguments.add_options_to(program);
      },
      [&] { return run(action, directory, arguments.chosen()); });
}
