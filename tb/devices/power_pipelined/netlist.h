// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "rtl_sysc/devices/pipelined.h"
#include "rtl_sysc/devices/power/power.h"
#include "tb/device.h"
#include "tb/netlist/elaborated.h"
#include "tb/specular/pipelined.h"

namespace blysk::power_pipelined_device {

template <class Q>
using type = power<power_formats<Q>, pipelined_device<power_formats<Q>, 12>>;

inline const specular::pipelined& of(const selection& asked) {
  return static_cast<const specular::pipelined&>(asked.of());
}

template <class Q>
std::vector<port> ports(const selection& asked) {
  return of(asked).with_stages(ports_of<type<Q>>(), asked);
}

template <class Q>
std::unique_ptr<netlist::elaborated> elaborate(const selection& asked, double clock_period_ns) {
  return std::make_unique<netlist::elaborated>(
      std::make_unique<type<Q>>("power_pipelined", of(asked).cuts(asked)), clock_period_ns, ports<Q>(asked));
}

}  // namespace blysk::power_pipelined_device
