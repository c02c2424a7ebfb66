// SPDX-License-Identifier: Apache-2.0
/// Tables of measured rows inside pages that people write.
#pragma once

#include <string>
#include <vector>

#include "tb/cost/measured.h"

namespace blysk::cost {

/// The page with each of its generated blocks made anew. A block stands between the lines
///     <!-- generated: WHAT -->
///     <!-- end of generated -->
/// and WHAT is one of
///     rows FORMAT...           what the formats cost
///     errors FORMAT...         their errors on each domain
///     front TECHNOLOGY METRIC DOMAIN
///     compare DEVICE DEVICE    two devices side by side in every format that was measured of both
///     reference DEVICE         the export beside the device written by hand, in every format that was measured of both
///     host FORMAT...           host time of the engines as ratios
///     energy STIMULUS FORMAT...  changes and energy for a result, with delays and without
///     energy-of-blocks STIMULUS DEVICE FORMAT
///     tools                    what measured
/// Figures that a paragraph quotes are compared with the rows, as check_figures() says.
/// \param path  for messages
/// \throws usage_error for a block that is unknown or has no end, or a figure that is not in its paragraph
std::string with_generated_blocks(const std::string& path, const std::string& page,
                                  const std::vector<configuration>& all);

}  // namespace blysk::cost
