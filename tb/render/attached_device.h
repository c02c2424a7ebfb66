// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/device.h"
#include "tb/engine.h"

namespace blysk::render {

/// A device beside the one that makes the highlights, and what computes it.
struct attached_device {
  selection device;
  engine* through;   ///< of one thread
  std::string name;  ///< of the engine
};

}  // namespace blysk::render
