// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/device.h"

namespace blysk::harness {

/// "--device NAME --format q12 --as-published": what chooses the device on a command line.
std::string arguments_of(const selection& asked);

/// What begins the comment in a VCD file that names the device, before arguments_of().
inline constexpr const char* kWaveComment = "blysk-device ";

}  // namespace blysk::harness
