// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "rtl_sysc/devices/lighting/lighting.h"
#include "tb/device.h"
#include "tb/netlist/elaborated.h"

namespace blysk::lighting_device {

template <class Q>
std::vector<port> ports(const selection& asked) {
  if (asked.flag("energy")) return ports_of<lighting<lighting_formats<Q, true>>>();
  return ports_of<lighting<lighting_formats<Q, false>>>();
}

template <class Q, bool HasEnergy>
std::unique_ptr<netlist::elaborated> elaborate_one(double clock_period_ns) {
  using type = lighting<lighting_formats<Q, HasEnergy>>;
  return std::make_unique<netlist::elaborated>(std::make_unique<type>("lighting"), clock_period_ns);
}

template <class Q>
std::unique_ptr<netlist::elaborated> elaborate(const selection& asked, double clock_period_ns) {
  return asked.flag("energy") ? elaborate_one<Q, true>(clock_period_ns)
                              : elaborate_one<Q, false>(clock_period_ns);
}

}  // namespace blysk::lighting_device
