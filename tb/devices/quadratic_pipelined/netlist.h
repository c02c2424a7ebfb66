// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "rtl_sysc/devices/pipelined.h"
#include "rtl_sysc/devices/quadratic/quadratic.h"
#include "tb/device.h"
#include "tb/devices/quadratic/wires.h"
#include "tb/netlist/elaborated.h"
#include "tb/specular/pipelined.h"

namespace blysk::quadratic_pipelined_device {

/// Calls use.operator()<Device>() with the type that the options ask for in format Q.
template <class Q, class Use>
auto with_type(const selection& asked, Use use) {
  const auto with_lobe = [&]<negative_lobe Lobe>() {
    using formats = quadratic_formats<Q, Lobe>;
    return use.template operator()<quadratic<formats, pipelined_device<formats, 5>>>();
  };
  return asked.flag("as-published") ? with_lobe.template operator()<negative_lobe::as_published>()
                                    : with_lobe.template operator()<negative_lobe::clamped>();
}

inline const specular::pipelined& of(const selection& asked) {
  return static_cast<const specular::pipelined&>(asked.of());
}

template <class Q>
std::vector<port> ports(const selection& asked) {
  return with_type<Q>(asked,
                      [&]<class Device>() { return of(asked).with_stages(ports_of<Device>(), asked); });
}

template <class Q>
std::unique_ptr<netlist::elaborated> elaborate(const selection& asked, double clock_period_ns) {
  return with_type<Q>(asked, [&]<class Device>() {
    return std::make_unique<netlist::elaborated>(
        std::make_unique<Device>("quadratic_pipelined", quadratic_device::wires(asked),
                                 of(asked).cuts(asked)),
        clock_period_ns, ports<Q>(asked));
  });
}

}  // namespace blysk::quadratic_pipelined_device
