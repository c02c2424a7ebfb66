// SPDX-License-Identifier: Apache-2.0
// draw_netlist [--output FILE.dot | --check FILE.dot] [--device D] [--format F] [OPTION...]: the figure of a device from its
// netlist, for Graphviz's dot, to standard output or a file; --check compares, and looks whether FILE.svg was made of the same
// text; exit 1 if not.
#include <fstream>
#include <iterator>

#include "tb/harness/drawing.h"
#include "tb/harness/text_program.h"

int sc_main(int, char**) {
  return 0;
}  // SystemC's library asks for one

int main(int argc, char** argv) {
  using namespace blysk;
  return harness::run_text_program(
      {.name = "draw_netlist",
       .description = "The figure of a device from its netlist, for Graphviz's dot",
       .target = "update_drawings",
       .text = harness::drawing_text,
       .is_made_of =
           [](const std::string& file, const std::string& text) {
             std::ifstream picture(file.substr(0, file.rfind('.')) + ".svg", std::ios::binary);
             const std::string drawn(std::istreambuf_iterator<char>(picture), {});
             return drawn.find('"' + harness::drawing_id(text) + '"') != std::string::npos;
           }},
      argc, argv);
}
