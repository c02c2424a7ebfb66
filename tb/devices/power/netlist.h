// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "rtl_sysc/devices/power/power.h"
#include "tb/device.h"
#include "tb/netlist/elaborated.h"

namespace blysk::power_device {

template <class Q>
using type = power<netlist::on_wires<power_formats<Q>>>;

template <class Q>
std::vector<port> ports(const selection&) {
  return ports_of<type<Q>>();
}

template <class Q>
std::unique_ptr<netlist::elaborated> elaborate(const selection&, double clock_period_ns) {
  return std::make_unique<netlist::elaborated>(std::make_unique<type<Q>>("power"), clock_period_ns);
}

}  // namespace blysk::power_device
