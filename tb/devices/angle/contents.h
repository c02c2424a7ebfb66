// SPDX-License-Identifier: Apache-2.0
/// What the options of `angle` say.
#pragma once

#include <cstdint>
#include <optional>

#include "rtl_sysc/devices/angle/contents.h"
#include "tb/device.h"

namespace blysk::angle_device {

/// 10^6 Q, 1..999999.
/// \throws std::invalid_argument if the text is no decimal number of (0, 1) with at most six decimals
std::uint64_t level_of(const selection& asked);

/// k, 1..15.
/// \throws std::invalid_argument for any other text
int powers_of(const selection& asked);

/// What the factor of the lobe is; nothing without one.
/// \throws std::invalid_argument if the published one does not hold for Q and k
std::optional<angle_energy> energy_of(const selection& asked);

}  // namespace blysk::angle_device
