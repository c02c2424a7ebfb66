// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tb/cosim/verilator_engine.h"
#include "tb/device.h"

namespace blysk::cli {

/// The ways to compute a device, as `--engine` names them.
struct engine_choice {
  std::string_view name;
  std::string_view help;
  purpose serves;
  bool is_recorded;  ///< --vcd can record its signals
  std::unique_ptr<engine> (*make)(const selection& asked, cosim::waves recorded);
};

const std::vector<engine_choice>& engine_choices();

/// The engine with measured delays, which `simulate` alone has: it takes more than a selection.
inline constexpr std::string_view kTimedEngine = "timed";

/// \param others  names that the caller knows besides, for the message
/// \throws std::invalid_argument for an engine that does not exist
const engine_choice& find_engine(const std::string& name, const std::vector<std::string_view>& others = {});

}  // namespace blysk::cli
