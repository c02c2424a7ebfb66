// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "rtl_sysc/devices/restoring_divider/restoring_divider.h"
#include "tb/device.h"
#include "tb/netlist/elaborated.h"

namespace blysk::restoring_divider_device {

template <class Q>
using type = restoring_divider<restoring_divider_formats<Q>>;

template <class Q>
std::vector<port> ports(const selection&) {
  return ports_of<type<Q>>();
}

template <class Q>
std::unique_ptr<netlist::elaborated> elaborate(const selection&, double clock_period_ns) {
  return std::make_unique<netlist::elaborated>(std::make_unique<type<Q>>("restoring_divider"),
                                               clock_period_ns);
}

}  // namespace blysk::restoring_divider_device
