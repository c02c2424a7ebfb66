// SPDX-License-Identifier: Apache-2.0
/// What the options of `angle` ask for, as types.
#pragma once

#include "rtl_sysc/devices/angle/formats.h"
#include "tb/devices/angle/contents.h"

namespace blysk::angle_device {

/// Calls use.operator()<Formats>() with the formats that the options ask for in format Q.
template <class Q, class Use>
auto with_formats(const selection& asked, Use use) {
  return energy_of(asked) ? use.template operator()<angle_formats<Q, true>>()
                          : use.template operator()<angle_formats<Q, false>>();
}

}  // namespace blysk::angle_device
