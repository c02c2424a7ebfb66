// SPDX-License-Identifier: Apache-2.0
/// What the option asks for, as a type.
#pragma once

#include "rtl_sysc/devices/lyon/lyon.h"
#include "tb/device.h"

namespace blysk::lyon_device {

/// Calls use.operator()<Formats>() with the formats of the degree that is asked for, in format Q.
template <class Q, class Use>
auto with_formats(const selection& asked, Use use) {
  const std::string& degree = asked.value("degree");
  if (degree == "2") return use.template operator()<lyon_formats<Q, 1>>();
  if (degree == "4") return use.template operator()<lyon_formats<Q, 2>>();
  return use.template operator()<lyon_formats<Q, 3>>();
}

}  // namespace blysk::lyon_device
