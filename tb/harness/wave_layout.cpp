// SPDX-License-Identifier: Apache-2.0
// wave_layout [--output FILE.gtkw | --check FILE.gtkw] [--device D] [--format F] [OPTION...]: GTKWave's layout for the
// waves of a device, to standard output or a file; --check compares, exit 1 if the file is another.
#include "tb/harness/layout.h"
#include "tb/harness/text_program.h"
#include "tb/run_program.h"

namespace {

const blysk::harness::text_program kProgram{
    .name = "wave_layout",
    .description = "GTKWave's layout for the waves of a device",
    .target = "update_layouts",
    .text = [](const blysk::selection& asked) { return blysk::harness::layout_text(asked); }};

}  // namespace

int sc_main(int, char**) {
  return 0;
}  // SystemC's library asks for one

int main(int argc, char** argv) {
  return blysk::run_program(kProgram.name, [&] { return blysk::harness::run_text(kProgram, argc, argv); });
}
