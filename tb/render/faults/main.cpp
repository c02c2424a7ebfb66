// SPDX-License-Identifier: Apache-2.0
// shading_faults FOLDER: writes a picture of each fault, and on standard output a row of docs/gallery.md for each.
#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

#include "tb/render/faults/gouraud.h"
#include "tb/run_program.h"

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

int main(int count, char** arguments) {
  return run_program("shading_faults", [&] {
    if (count != 2) throw std::invalid_argument("a folder is expected");
    write_faults(arguments[1]);
    return 0;
  });
}
