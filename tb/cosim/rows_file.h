// SPDX-License-Identifier: Apache-2.0
/// Rows that a device's own tests ask for besides those that its ports give.
#pragma once

#include <string>

#include "tb/device.h"

namespace blysk::cosim {

/// Rows from a CSV file with a column for each data port, as the device's stimulus has them, but of raw codes.
/// \throws usage_error for a file that cannot be read, another header, a field that is no legal code of its port, and a
///         file without rows
columns read_rows(const selection& asked, const std::string& path);

}  // namespace blysk::cosim
