// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/device.h"

namespace blysk::harness {

/// The layout of GTKWave for the waves of a device (a .gtkw file): clock, strobes and data as in fig. 3 of [P], results,
/// then every block in the order of the data. Widths, fraction bits and signs are those of the ports and blocks. Elaborates
/// the device: a process does that once.
/// \param root  scope of the waves, "SystemC"
std::string layout_text(const selection& asked, const std::string& root = "SystemC");

/// "--device NAME --format q12 --as-published": what chooses the device on a command line.
std::string arguments_of(const selection& asked);

/// What begins the comment in a VCD file that names the device, before arguments_of().
inline constexpr const char* kWaveComment = "blysk-device ";

}  // namespace blysk::harness
