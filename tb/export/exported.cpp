// SPDX-License-Identifier: Apache-2.0
// exported check|update DIRECTORY DEVICE FORMAT: rtl_verilog/ is what the SystemC model exports, or is made so.
// exported replay DIRECTORY DEVICE FORMAT [--coefficient C] [--constant BITS] [--as-published]: the export, and below
//   replay/ a run of the SystemC device for a Verilog simulator to repeat.
// A process elaborates one device. Exit 1 if the directory holds anything else.
#include <fmt/format.h>

#include <fstream>
#include <iterator>

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

int check(const files& exported, const fs::path& directory) {
  const files there = read_directory(directory);
  int differences = 0;
  for (const auto& [name, text] : exported) {
    const auto found = there.find(name);
    if (found != there.end() && found->second == text) continue;
    fmt::print("{}: {}\n", name, found == there.end() ? "missing" : "differs");
    ++differences;
  }
  for (const auto& [name, text] : there) {
    if (exported.contains(name)) continue;
    fmt::print("{}: not exported\n", name);
    ++differences;
  }
  return differences == 0 ? 0 : 1;
}

device_options parse(int argc, char** argv) {
  device_options options;
  options.device = argv[3];
  options.format = argv[4];
  for (int i = 5; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--as-published") {
      options.as_published = true;
    } else if (i + 1 < argc && (word == "--coefficient" || word == "--constant")) {
      (word == "--constant" ? options.constant : options.coefficient) = argv[++i];
    } else {
      throw std::invalid_argument(word + " is not an option");
    }
  }
  return options;
}

int run(int argc, char** argv) {
  if (argc < 5)
    throw std::invalid_argument("usage: exported check|update|replay DIRECTORY DEVICE FORMAT [OPTION...]");
  const std::string action = argv[1];
  const fs::path directory = argv[2];
  const device_options options = parse(argc, argv);
  const auto device = make_model(options);
  const files exported = export_files(*device, options);
  if (action == "check") return check(exported, directory);
  if (action == "update") fs::remove_all(directory);
  fs::create_directories(directory);
  write_files(exported, directory);
  if (action == "replay") {
    constexpr int kCycles = 2000;
    fs::create_directories(directory / "replay");
    write_replay(*device, top_name(options), kCycles, directory / "replay");
  }
  return 0;
}

}  // namespace

int sc_main(int, char**) {
  return 0;
}  // SystemC's library asks for one

int main(int argc, char** argv) {
  return blysk::run_program("exported", [&] { return run(argc, argv); });
}
