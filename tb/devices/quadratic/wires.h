// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/devices/quadratic/formats.h"
#include "tb/device.h"

namespace blysk::quadratic_device {

/// The wires of nodes 31 and 32 that the options ask for.
/// \param bits  of the slope's constant
/// \throws std::invalid_argument for a constant that does not start with one, is longer than the node, or holds anything
///         but bits
wired_constants wires(const selection& asked, int bits);

/// In the selection's format.
wired_constants wires(const selection& asked);

}  // namespace blysk::quadratic_device
