// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "rtl_sysc/devices/shift_divider/shift_divider.h"
#include "tb/device.h"
#include "tb/netlist/elaborated.h"

namespace blysk::shift_divider_device {

template <class Q>
std::vector<port> ports(const selection&) {
  return ports_of<shift_divider<shift_divider_formats<Q>>>();
}

template <class Q>
std::unique_ptr<netlist::elaborated> elaborate(const selection&, double clock_period_ns) {
  using type = shift_divider<shift_divider_formats<Q>>;
  return std::make_unique<netlist::elaborated>(std::make_unique<type>("shift_divider"), clock_period_ns);
}

}  // namespace blysk::shift_divider_device
