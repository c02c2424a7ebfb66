// SPDX-License-Identifier: Apache-2.0
#include "tb/export/export.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>

#include "tb/cli/verbs.h"
#include "tb/cost/annotated.h"
#include "tb/device_arguments.h"
#include "tb/export/serial.h"
#include "tb/netlist/elaborated.h"
#include "tb/output_file.h"

namespace blysk::cli {
namespace {

struct options {
  asked_device device;
  std::string output, wrapper;
};

constexpr const char* kSerial = "serial";

/// An export is replaced by one of the same device and options alone.
/// \throws usage_error if the folder holds another one under the same names
void expect_same_export(const std::string& folder, const std::string& top, const std::string& text) {
  const std::filesystem::path path = std::filesystem::path(folder) / top;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return;
  std::ifstream file(path, std::ios::binary);
  constexpr std::string_view kBegin = "// device ";
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(kBegin)) {
      if (!line.starts_with("//")) return;  // not written here; its folder is judged by the names in it
      continue;
    }
    const std::string there = line.substr(3, line.rfind(", exported from") - 3);
    if (there == text) return;
    throw file_error(
        folder, 0,
        fmt::format("holds {}, expected an empty directory or one with files of the export of {}", there,
                    text));
  }
}

void run(const options& asked) {
  const selection chosen = asked.device.choose();
  const std::string name = asked.device.export_name();
  const auto device = chosen.of().elaborate(chosen, 0);
  verilog::files files = cost::annotated_export(*device, chosen, name);
  if (asked.wrapper == kSerial) {
    files[name + "_serial.v"] = verilog::serial_text(*device, name, chosen.text());
    files[name + "_serial.pcf"] = verilog::serial_pins(name);
  }
  if (asked.output == "-")
    throw usage_error("--output is -, expected a directory: an export has several files");
  expect_same_export(asked.output, name + ".v", chosen.text());
  write_directory(asked.output, files);
  fmt::print("{}: read it with the file list {}.f{}\n", printable(asked.output), name,
             asked.wrapper.empty() ? "" : fmt::format(" and {}_serial.v", name));
}

}  // namespace

void add_export(CLI::App& program) {
  auto* verb = program.add_subcommand("export", "Write a device's Verilog-2001, made from its SystemC");
  auto asked = std::make_shared<options>();
  add_device_arguments(*verb, asked->device, purpose::hardware);
  verb->add_option("--output", asked->output,
                   "directory, empty or with the files of an export before; made if it does not exist")
      ->required();
  verb->add_option(
          "--wrapper", asked->wrapper,
          "write NAME_serial.v and .pcf too: the device behind a serial line, for an iCE40 HX8K breakout "
          "board; a line of blysk vectors goes in and comes back with the outputs")
      ->check(CLI::IsMember({kSerial}));
  verb->footer(
      "Examples:\n"
      "  blysk export --format q12 --output rtl\n"
      "  blysk export --format q8 --wrapper serial --output rtl-serial\n"
      "  blysk export --format q8 --as-published --output rtl-published");
  verb->callback([asked] { run(*asked); });
}

}  // namespace blysk::cli
