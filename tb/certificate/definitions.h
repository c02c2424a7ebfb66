// SPDX-License-Identifier: Apache-2.0
/// Definitions for Gappa, computed: they are what the netlist computes if both give the same results.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "tb/netlist/gappa_path.h"

namespace blysk {

/// Numbers of up to 64 bits are exact.
using named_numbers = std::map<std::string, long double>;

/// The net `result` of the one path whose conditions hold, where the inputs' codes are `given`, by the names that their
/// definitions have, "cos_i_code". Empty if the conditions of no path hold.
/// \throws std::logic_error for a text that is no definition, and where the conditions of two paths hold
std::optional<long double> compute(const netlist::gappa_netlist& of, const named_numbers& given,
                                   const std::string& result);

}  // namespace blysk
