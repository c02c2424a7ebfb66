// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "rtl_sysc/devices/quadratic/quadratic.h"
#include "tb/device.h"
#include "tb/devices/quadratic/wires.h"
#include "tb/netlist/elaborated.h"

namespace blysk::quadratic_device {

/// Calls use.operator()<quadratic<Formats>>() with the type that the options ask for in format Q.
template <class Q, class Use>
auto with_type(const selection& asked, Use use) {
  return asked.flag("as-published")
             ? use.template
               operator()<quadratic<netlist::on_wires<quadratic_formats<Q, negative_lobe::as_published>>>>()
             : use.template
               operator()<quadratic<netlist::on_wires<quadratic_formats<Q, negative_lobe::clamped>>>>();
}

template <class Q>
std::vector<port> ports(const selection& asked) {
  return with_type<Q>(asked, []<class Device>() { return ports_of<Device>(); });
}

template <class Q>
std::unique_ptr<netlist::elaborated> elaborate(const selection& asked, double clock_period_ns) {
  return with_type<Q>(asked, [&]<class Device>() {
    return std::make_unique<netlist::elaborated>(std::make_unique<Device>("quadratic", wires(asked)),
                                                 clock_period_ns);
  });
}

}  // namespace blysk::quadratic_device
