// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace blysk::cli {

inline constexpr std::string_view engine_names[] = {"golden", "bit", "systemc", "verilator"};

}  // namespace blysk::cli
