// SPDX-License-Identifier: Apache-2.0
/// Measured figures inside sentences that people write.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tb/cost/measured.h"

namespace blysk::cost {

/// Compares a paragraph with what it says it quotes. Above it stands the line
///     <!-- figures: DEVICE FORMAT COLUMN [DOMAIN], ... -->
/// COLUMN is one of `blysk explore --csv`, of the device with its presets; DOMAIN (preset lobe) is for errors. DEVICE/DEVICE is
/// the ratio of two. Each figure has to be in the paragraph as a number, rounded to the digits that it has there; zeros at
/// the end of a whole number of more than two digits count as rounded.
/// \param path, line  where that line stands, for messages
/// \param quoted      what is between "figures:" and "-->"
/// \throws usage_error for a figure that is not in the paragraph, that was not measured or that does not exist
void check_figures(const std::string& path, std::size_t line, const std::string& quoted,
                   const std::string& paragraph, const std::vector<configuration>& all);

}  // namespace blysk::cost
