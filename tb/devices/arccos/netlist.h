// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "rtl_sysc/devices/arccos/arccos.h"
#include "tb/device.h"
#include "tb/netlist/elaborated.h"

namespace blysk::arccos_device {

template <class Q>
std::vector<port> ports(const selection&) {
  return ports_of<arccos<arccos_formats<Q>>>();
}

template <class Q>
std::unique_ptr<netlist::elaborated> elaborate(const selection&, double clock_period_ns) {
  using type = arccos<arccos_formats<Q>>;
  return std::make_unique<netlist::elaborated>(std::make_unique<type>("arccos"), clock_period_ns);
}

}  // namespace blysk::arccos_device
