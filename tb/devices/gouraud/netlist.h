// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "rtl_sysc/devices/gouraud/gouraud.h"
#include "tb/device.h"
#include "tb/netlist/elaborated.h"

namespace blysk::gouraud_device {

template <class Q>
std::vector<port> ports(const selection&) {
  return ports_of<gouraud<gouraud_formats<Q>>>();
}

template <class Q>
std::unique_ptr<netlist::elaborated> elaborate(const selection&, double clock_period_ns) {
  using type = gouraud<gouraud_formats<Q>>;
  return std::make_unique<netlist::elaborated>(std::make_unique<type>("gouraud"), clock_period_ns);
}

}  // namespace blysk::gouraud_device
