// SPDX-License-Identifier: Apache-2.0
/// What the option asks for, as a type.
#pragma once

#include "rtl_sysc/devices/rational/formats.h"
#include "tb/device.h"

namespace blysk::rational_device {

/// Calls use.operator()<Formats>() with the formats of the coefficients that are asked for, in format Q.
template <class Q, class Use>
auto with_formats(const selection& asked, Use use) {
  if (asked.value("fit") == "line") return use.template operator()<rational_formats<Q, rational_fit::line>>();
  return use.template operator()<rational_formats<Q, rational_fit::best>>();
}

}  // namespace blysk::rational_device
