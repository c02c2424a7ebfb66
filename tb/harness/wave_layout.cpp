// SPDX-License-Identifier: Apache-2.0
// wave_layout [--output FILE.gtkw | --check FILE.gtkw] [--device D] [--format F] [OPTION...]: GTKWave's layout for the
// waves of a device, to standard output or a file; --check compares, exit 1 if the file is another.
#include "tb/harness/text_program.h"
#include "tb/netlist/layout.h"
#include "tb/run_program.h"

namespace {

std::string layout_of(const blysk::selection& asked) {
  using namespace blysk::netlist;
  const auto device = asked.of().elaborate(asked, 0);
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  return layout_text(*device, asked.text(), "SystemC", waves_of::systemc);
}

const blysk::harness::text_program kProgram{.name = "wave_layout",
                                            .description = "GTKWave's layout for the waves of a device",
                                            .target = "update_layouts",
                                            .text = layout_of};

}  // namespace

int sc_main(int, char**) {
  return 0;
}  // SystemC's library asks for one

int main(int argc, char** argv) {
  return blysk::run_program(kProgram.name, [&] { return blysk::harness::run_text(kProgram, argc, argv); });
}
