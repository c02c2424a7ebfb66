// SPDX-License-Identifier: Apache-2.0
#include "tb/export/export.h"

#include <fmt/format.h>

#include <memory>

#include "tb/cli/verbs.h"
#include "tb/cost/measured.h"
#include "tb/device_arguments.h"
#include "tb/output_file.h"

namespace blysk::cli {
namespace {

struct options {
  asked_device device;
  std::string output;
};

void run(const options& asked) {
  const selection device = asked.device.choose();
  write_directory(asked.output, verilog::export_files(device, cost::clock_of(device)));
  fmt::print("{}: read it with the file list {}.f\n", printable(asked.output), device.top_name());
}

}  // namespace

void add_export(CLI::App& program) {
  auto* verb = program.add_subcommand("export", "Write a device's Verilog-2001, made from its SystemC");
  auto asked = std::make_shared<options>();
  add_device_arguments(*verb, asked->device, purpose::hardware);
  verb->add_option("--output", asked->output,
                   "directory, empty or with the files of an export before; made if it does not exist")
      ->required();
  verb->footer(
      "Examples:\n"
      "  blysk export --format q12 --output rtl\n"
      "  blysk export --format q8 --as-published --output rtl-published");
  verb->callback([asked] { run(*asked); });
}

}  // namespace blysk::cli
