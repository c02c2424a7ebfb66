// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/device.h"

namespace blysk::quadratic_rom_device {

/// Which of the memory's contents the options ask for: 0 exact, 1 derived, 2 published.
inline int contents(const selection& asked) {
  const std::string& name = asked.value("coefficient");
  return name == "exact" ? 0 : name == "derived" ? 1 : 2;
}

}  // namespace blysk::quadratic_rom_device
