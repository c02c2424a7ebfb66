// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/text_program.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "tb/device_arguments.h"
#include "tb/output_file.h"
#include "tb/usage_error.h"

namespace blysk::harness {

int run_text(const text_program& of, int argc, char** argv) {
  CLI::App program{of.description, of.name};
  asked_device asked;
  std::string output = "-";
  std::string check;
  add_device_arguments(program, asked, purpose::hardware);
  program.add_option("--output", output, "file to write, - for standard output")->capture_default_str();
  program.add_option("--check", check, "file to compare with");
  if (of.add_options) of.add_options(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return program.exit(success);
  } catch (const CLI::Error& error) {
    throw usage_error(fmt::format("{}, see {} --help", error.what(), of.name));
  }
  const std::string text = of.text(asked.choose());
  if (!check.empty()) {
    std::ifstream file(check, std::ios::binary);
    const bool is_same = std::string(std::istreambuf_iterator<char>(file), {}) == text;
    if (is_same && (!of.is_made_of || of.is_made_of(check, text))) return 0;
    fmt::print("{} is stale: the target {} writes it\n", check, of.target);
    return 1;
  }
  output_file file(output);
  file.write(text);
  file.commit();
  return 0;
}

}  // namespace blysk::harness
