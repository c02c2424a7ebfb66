// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "rtl_sysc/devices/quadratic_rom/quadratic_rom.h"
#include "tb/device.h"
#include "tb/devices/quadratic_rom/words.h"
#include "tb/netlist/elaborated.h"

namespace blysk::quadratic_rom_device {

/// Calls use.operator()<quadratic_rom<Formats, Kind>>() with the type that the options ask for in format Q.
template <class Q, class Use>
auto with_type(const selection& asked, Use use) {
  const auto with_lobe = [&]<negative_lobe Lobe>() {
    using formats = netlist::on_wires<quadratic_rom_formats<Q, Lobe>>;
    return asked.value("rom") == "clocked"
               ? use.template operator()<quadratic_rom<formats, rom_kind::clocked>>()
               : use.template operator()<quadratic_rom<formats, rom_kind::logic>>();
  };
  return asked.flag("as-published") ? with_lobe.template operator()<negative_lobe::as_published>()
                                    : with_lobe.template operator()<negative_lobe::clamped>();
}

template <class Q>
std::vector<port> ports(const selection& asked) {
  return with_type<Q>(asked, []<class Device>() { return ports_of<Device>(); });
}

template <class Q>
std::unique_ptr<netlist::elaborated> elaborate(const selection& asked, double clock_period_ns) {
  return with_type<Q>(asked, [&]<class Device>() {
    return std::make_unique<netlist::elaborated>(std::make_unique<Device>("quadratic_rom", contents(asked)),
                                                 clock_period_ns);
  });
}

}  // namespace blysk::quadratic_rom_device
