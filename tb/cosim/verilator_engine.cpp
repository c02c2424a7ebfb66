// SPDX-License-Identifier: Apache-2.0
#include "tb/cosim/verilator_engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "tb/cosim/verilated_table.h"

namespace blysk::cosim {

std::unique_ptr<verilator_engine> make_verilator(const selection& asked) {
  if (!asked.is_preset()) {
    throw std::invalid_argument(fmt::format(
        "engine verilator has the presets compiled in ({}), expected those; export the device for others",
        choose(asked.of().name(), asked.format()).text()));
  }
  const auto table = exported_table();
  const auto found = std::ranges::find(table, asked.folder_name(), &verilated_entry::folder);
  if (found == table.end()) {
    throw std::invalid_argument(
        fmt::format("engine verilator has no device {} in format {}, expected a build with Verilator",
                    asked.of().name(), asked.format()));
  }
  return found->make();
}

}  // namespace blysk::cosim
