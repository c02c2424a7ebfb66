// SPDX-License-Identifier: Apache-2.0
/// Numbers in text, as programs write them; whatever the locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace blysk {

/// How far outside its range a number may lie to be taken for its end: one ulp of single precision above 1.
inline constexpr double kClampReach = 0x1p-23;

/// A real number from a text that it takes whole: 0.5, +.5, 5e-1, inf, nan. The nearest double, 0 if it is too small for
/// one, infinite if it is too large. Nothing if the text is no number.
std::optional<double> read_real(std::string_view text);

/// An integer in any form that is one: 10, +10, 10.0, 1.000e+01. Nothing if the text is none, or too large.
std::optional<std::int64_t> read_integer(std::string_view text);

}  // namespace blysk
