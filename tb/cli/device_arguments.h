// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "tb/device.h"

namespace blysk::cli {

/// Adds the options that choose a device to a verb. \param coefficients  the lines that the verb can serve
void add_device_arguments(CLI::App& verb, device_options& device,
                          const std::vector<std::string>& coefficients);

}  // namespace blysk::cli
