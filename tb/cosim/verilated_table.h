// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "tb/cosim/verilator_engine.h"

namespace blysk::cosim {

/// A Verilated class that is linked in.
struct verilated_entry {
  /// selection::folder_name(), and behind it the options that differ from the presets: "lighting_q8 --energy".
  std::string_view name;
  std::unique_ptr<verilator_engine> (*make)();
};

// The tables are made by CMake (verilated.cmake), the last one for a program of one device and format.
std::span<const verilated_entry> exported_table();
std::span<const verilated_entry> traced_table();
std::span<const verilated_entry> reference_table();
std::span<const verilated_entry> covered_table();

}  // namespace blysk::cosim
