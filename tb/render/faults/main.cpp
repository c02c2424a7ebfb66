// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

#include "tb/program.h"
#include "tb/render/faults/gouraud.h"

namespace {

using namespace blysk;

void write_faults(const std::string& folder) {
  const selection device = choose(devices().front()->name(), "q16");
  const auto make = [&] { return device.of().make_bit(device); };
  const auto only = make();
  const render::device_source from{device, [&](unsigned) { return only.get(); }, false, make};
  for (const render::gouraud_fault& each : render::find_gouraud_faults(from)) {
    std::ofstream file(folder + "/" + each.name + ".png", std::ios::binary);
    file << render::png_of(each.sheet);
    if (!file.flush()) throw std::runtime_error("cannot write into " + folder);
    fmt::print("| {} | ![{}](figures/gallery/{}.png) | {} | {:.4g} | {:.4g} |\n", each.what, each.name,
               each.name, each.measured, each.gouraud, each.other);
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::string folder;
  return run_program(
      argc, argv,
      "Writes a picture of each fault of Gouraud's shading, and on standard output its row of "
      "docs/gallery.md",
      [&](CLI::App& program) { program.add_option("FOLDER", folder, "of the pictures")->required(); },
      [&] {
        write_faults(folder);
        return 0;
      });
}
