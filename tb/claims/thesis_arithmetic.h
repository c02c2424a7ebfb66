// SPDX-License-Identifier: Apache-2.0
/// Those rows of [T] that whole numbers and a pencil decide.
#pragma once

#include <vector>

#include "tb/claims/claim.h"

namespace blysk::golden {

/// 2.4: division by shifts, and what a triangle costs.
void add_gouraud(std::vector<claim>& rows);

/// 2.6, 3.1 and chapter 4: processing elements, the device's blocks, worked examples of another trade.
void add_devices(std::vector<claim>& rows);

}  // namespace blysk::golden
