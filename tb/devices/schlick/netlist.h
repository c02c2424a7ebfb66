// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "rtl_sysc/devices/schlick/schlick.h"
#include "tb/device.h"
#include "tb/netlist/elaborated.h"

namespace blysk::schlick_device {

template <class Q>
using type = schlick<netlist::on_wires<schlick_formats<Q>>>;

template <class Q>
std::vector<port> ports(const selection&) {
  return ports_of<type<Q>>();
}

template <class Q>
std::unique_ptr<netlist::elaborated> elaborate(const selection&, double clock_period_ns) {
  return std::make_unique<netlist::elaborated>(std::make_unique<type<Q>>("schlick"), clock_period_ns);
}

}  // namespace blysk::schlick_device
