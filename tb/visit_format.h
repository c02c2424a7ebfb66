// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

#include "rtl_sysc/formats.h"

namespace blysk {

/// Calls visitor.operator()<Q>() with the named format.
/// \throws std::invalid_argument for a format that does not exist
template <class Visitor>
auto visit_format(const std::string& format, Visitor&& visitor) {
#define BLYSK_NAMED_FORMAT(name) \
  if (format == #name) return visitor.template operator()<name>();
#include "tb/formats.def"
#undef BLYSK_NAMED_FORMAT
  throw std::invalid_argument("format " + format + " does not exist");
}

}  // namespace blysk
