// SPDX-License-Identifier: Apache-2.0
#include "tb/export/export.h"

#include <fmt/format.h>

#include <memory>

#include "tb/cli/device_arguments.h"
#include "tb/cli/verbs.h"
#include "tb/output_file.h"

namespace blysk::cli {
namespace {

struct options {
  device_options device;
  std::string output;
};

void run(const options& asked) {
  const auto device = verilog::make_model(asked.device);
  write_directory(asked.output, verilog::export_files(*device, asked.device));
  fmt::print("{}: read it with the file list {}.f\n", printable(asked.output),
             verilog::top_name(asked.device));
}

}  // namespace

void add_export(CLI::App& program) {
  auto* verb = program.add_subcommand("export", "Write a device's Verilog-2001, made from its SystemC");
  auto asked = std::make_shared<options>();
  add_device_arguments(*verb, asked->device, {"published", "derived"});
  verb->add_option("--output", asked->output,
                   "directory, empty or with the files of an export before; made if it does not exist")
      ->required();
  verb->callback([asked] { run(*asked); });
}

}  // namespace blysk::cli
