// SPDX-License-Identifier: Apache-2.0
// wave_layout [--output FILE.gtkw | --check FILE.gtkw] [--verilog] [--device D] [--format F] [OPTION...]: GTKWave's layout
// for the waves of a device, or of its exported Verilog, to standard output or a file; --check compares, exit 1 if the file
// is another.
#include <CLI/CLI.hpp>

#include "tb/harness/text_program.h"
#include "tb/netlist/layout.h"
#include "tb/run_program.h"

namespace {

constexpr const char* kName = "wave_layout";

std::string layout_of(const blysk::selection& asked, bool is_verilog) {
  using namespace blysk::netlist;
  const auto device = asked.of().elaborate(asked, 0);
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  return is_verilog ? layout_text(*device, asked.text(), "TOP." + asked.top_name(), waves_of::verilog)
                    : layout_text(*device, asked.text(), "SystemC", waves_of::systemc);
}

int run(int argc, char** argv) {
  bool is_verilog = false;
  return blysk::harness::run_text(
      {.name = kName,
       .description = "GTKWave's layout for the waves of a device",
       .target = "update_layouts",
       .text = [&](const blysk::selection& asked) { return layout_of(asked, is_verilog); },
       .add_options =
           [&](CLI::App& program) {
             program.add_flag("--verilog", is_verilog,
                              "for the waves that Verilator writes of the exported Verilog");
           }},
      argc, argv);
}

}  // namespace

int sc_main(int, char**) {
  return 0;
}  // SystemC's library asks for one

int main(int argc, char** argv) {
  return blysk::run_program(kName, [&] { return run(argc, argv); });
}
