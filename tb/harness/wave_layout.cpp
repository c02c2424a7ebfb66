// SPDX-License-Identifier: Apache-2.0
// wave_layout [--output FILE.gtkw | --check FILE.gtkw] [--device D] [--format F] [OPTION...]: GTKWave's layout for the
// waves of a device, to standard output or a file; --check compares, exit 1 if the file is another.
#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "tb/device_arguments.h"
#include "tb/harness/layout.h"
#include "tb/output_file.h"
#include "tb/run_program.h"
#include "tb/usage_error.h"

namespace {

using namespace blysk;

int run(int argc, char** argv) {
  CLI::App program{"GTKWave's layout for the waves of a device", "wave_layout"};
  asked_device asked;
  std::string output = "-";
  std::string check;
  add_device_arguments(program, asked, purpose::hardware);
  program.add_option("--output", output, "file to write, - for standard output")->capture_default_str();
  program.add_option("--check", check, "file to compare with");
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return program.exit(success);
  } catch (const CLI::Error& error) {
    throw usage_error(fmt::format("{}, see wave_layout --help", error.what()));
  }
  const std::string text = harness::layout_text(asked.choose());
  if (!check.empty()) {
    std::ifstream file(check, std::ios::binary);
    if (std::string(std::istreambuf_iterator<char>(file), {}) == text) return 0;
    fmt::print("{} is stale: the target update_layouts writes it\n", check);
    return 1;
  }
  output_file file(output);
  file.write(text);
  file.commit();
  return 0;
}

}  // namespace

int sc_main(int, char**) {
  return 0;
}  // SystemC's library asks for one

int main(int argc, char** argv) {
  return blysk::run_program("wave_layout", [&] { return run(argc, argv); });
}
