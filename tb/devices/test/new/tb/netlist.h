// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "rtl_sysc/devices/linear/linear.h"
#include "tb/device.h"
#include "tb/netlist/elaborated.h"

namespace blysk::linear_device {

template <class Q>
std::vector<port> ports(const selection&) {
  return ports_of<linear<linear_formats<Q>>>();
}

template <class Q>
std::unique_ptr<netlist::elaborated> elaborate(const selection&, double clock_period_ns) {
  return std::make_unique<netlist::elaborated>(std::make_unique<linear<linear_formats<Q>>>("linear"),
                                               clock_period_ns);
}

}  // namespace blysk::linear_device
