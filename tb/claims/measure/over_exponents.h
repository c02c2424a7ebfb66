// SPDX-License-Identifier: Apache-2.0
/// Figures over a range of exponents.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "tb/claims/figure.h"
#include "tb/claims/sweep.h"

namespace blysk::claims {

/// Keys end with these: 060, 056, infl.
std::string_view key_of(epicentre where);

/// KEY the value, KEY_n where it lies.
void add_worst(figures& into, const std::string& key, const worst& w);
void add_worst_percent(figures& into, const std::string& key, const worst& w);

/// "n in 1..39", "no n".
std::string exponents_where(int first, int last, const std::function<bool(int)>& holds);

}  // namespace blysk::claims
