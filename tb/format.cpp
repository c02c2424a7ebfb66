// SPDX-License-Identifier: Apache-2.0
#include "tb/format.h"

#include <fmt/format.h>

#include <cmath>

namespace blysk {

std::string wire_format::text() const {
  return fmt::format("{}Q{}.{}", is_signed ? 'S' : 'U', integer, frac);
}

std::string wire_format::note() const {
  const auto top = static_cast<std::int64_t>((std::uint64_t{1} << (integer + frac)) - 1);
  const bool is_whole = max == top && min == (is_signed ? -top - 1 : 0);
  return text() + (is_whole ? "" : fmt::format(", codes {}..{}", min, max));
}

std::string wire_format::name() const {
  return fmt::format("{}q{}{}_{}", is_signed ? 's' : 'u', integer < 0 ? "m" : "", std::abs(integer), frac);
}

std::string wire_format::value(std::int64_t raw) const {
  return fmt::format("{:.6g}", std::ldexp(static_cast<double>(raw), -frac));
}

}  // namespace blysk
