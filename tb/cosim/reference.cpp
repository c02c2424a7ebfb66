// SPDX-License-Identifier: Apache-2.0
#include "tb/cosim/reference.h"

#include <algorithm>

#include "tb/cosim/verilated_table.h"

namespace blysk::cosim {

std::unique_ptr<verilator_engine> make_reference(const selection& asked) {
  if (!asked.is_preset()) return nullptr;
  const auto table = reference_table();
  const auto found = std::ranges::find(table, asked.folder_name(), &verilated_entry::name);
  return found == table.end() ? nullptr : found->make();
}

}  // namespace blysk::cosim
