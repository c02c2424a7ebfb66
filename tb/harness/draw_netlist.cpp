// SPDX-License-Identifier: Apache-2.0
// draw_netlist [--output FILE.dot | --check FILE.dot] [--device D] [--format F] [OPTION...]: the figure of a device from its
// netlist, for Graphviz's dot, to standard output or a file; --check compares, and looks whether FILE.svg was made of the same
// text; exit 1 if not.
#include <fstream>
#include <iterator>

#include "tb/harness/drawing.h"
#include "tb/harness/text_program.h"
#include "tb/run_program.h"

namespace {

/// Whether the picture beside the text bears its name.
bool is_drawn(const std::string& file, const std::string& text) {
  std::ifstream picture(file.substr(0, file.rfind('.')) + ".svg", std::ios::binary);
  const std::string drawn(std::istreambuf_iterator<char>(picture), {});
  return drawn.find('"' + blysk::harness::drawing_id(text) + '"') != std::string::npos;
}

const blysk::harness::text_program kProgram{
    .name = "draw_netlist",
    .description = "The figure of a device from its netlist, for Graphviz's dot",
    .target = "update_drawings",
    .text = blysk::harness::drawing_text,
    .is_made_of = is_drawn};

}  // namespace

int sc_main(int, char**) {
  return 0;
}  // SystemC's library asks for one

int main(int argc, char** argv) {
  return blysk::run_program(kProgram.name, [&] { return blysk::harness::run_text(kProgram, argc, argv); });
}
