// SPDX-License-Identifier: Apache-2.0
#include "tb/export/export.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "tb/cli/device_arguments.h"
#include "tb/cli/files.h"
#include "tb/cli/verbs.h"

namespace blysk::cli {
namespace {

struct options {
  device_options device;
  std::string output;
};

void run(const options& asked) {
  std::error_code ignored;
  if (std::filesystem::exists(asked.output, ignored) &&
      !std::filesystem::is_directory(asked.output, ignored)) {
    throw file_error(asked.output, 0, "is no directory, expected one to write into");
  }
  verilog::export_device(asked.device, asked.output);
  fmt::print("{}: read it with the file list {}.f\n", asked.output, verilog::top_name(asked.device));
}

}  // namespace

void add_export(CLI::App& program) {
  auto* verb = program.add_subcommand("export", "Write a device's Verilog-2001, made from its SystemC");
  auto asked = std::make_shared<options>();
  add_device_arguments(*verb, asked->device, {"published", "derived"});
  verb->add_option("--output", asked->output, "directory, made if it does not exist")->required();
  verb->callback([asked] { run(*asked); });
}

}  // namespace blysk::cli
