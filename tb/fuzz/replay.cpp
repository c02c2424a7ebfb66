// SPDX-License-Identifier: Apache-2.0
// The main function of a fuzz target in a build without libFuzzer: tries the inputs that are kept, files or folders of
// them.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "tb/fuzz/fuzz.h"
#include "tb/run_program.h"
#include "tb/usage_error.h"

namespace {

namespace fs = std::filesystem;

int run(std::span<char*> arguments) {
  std::vector<fs::path> files;
  for (const fs::path argument : arguments) {
    if (!fs::is_directory(argument)) files.push_back(argument);
    if (!fs::is_directory(argument)) continue;
    for (const auto& entry : fs::directory_iterator(argument)) files.push_back(entry.path());
  }
  if (files.empty()) throw blysk::usage_error("no inputs, expected files or folders of them");
  for (const fs::path& each : files) {
    std::printf("%s\n", each.c_str());
    std::fflush(stdout);
    std::ifstream file(each, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file) throw blysk::file_error(each.string(), 0, "cannot be read");
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  }
  return 0;
}

}  // namespace

int sc_main(int, char**) {
  return 0;
}

int main(int argc, char** argv) {
  return blysk::run_program("replay", [&] { return run(std::span(argv + 1, argv + argc)); });
}
