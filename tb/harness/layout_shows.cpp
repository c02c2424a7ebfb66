// SPDX-License-Identifier: Apache-2.0
// layout_shows [--all] FILE.vcd FILE.gtkw: how many rows of GTKWave's layout show a signal of the waveform. Exit status: 0
// some do, or all with --all; 1 otherwise.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "tb/harness/wave_names.h"
#include "tb/run_program.h"
#include "tb/usage_error.h"

namespace {

int run(int argc, char** argv) {
  CLI::App program{"Counts the rows of a layout of GTKWave that show a signal of a waveform", "layout_shows"};
  std::string vcd;
  std::string layout;
  bool wants_all = false;
  program.add_flag("--all", wants_all, "every row has to show a signal");
  program.add_option("waveform", vcd, "a VCD file")->required();
  program.add_option("layout", layout, "a .gtkw file")->required();
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return program.exit(success);
  } catch (const CLI::Error& error) {
    throw blysk::usage_error(fmt::format("{}, see layout_shows --help", error.what()));
  }
  const auto [shown, unknown] = blysk::harness::rows_of(layout, blysk::harness::declared_signals(vcd));
  fmt::print("{} rows show a signal, {} do not\n", shown, unknown);
  return shown == 0 || (wants_all && unknown > 0) ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  return blysk::run_program("layout_shows", [&] { return run(argc, argv); });
}
