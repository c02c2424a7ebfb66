// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "tb/devices/lyon/degree.h"
#include "tb/netlist/elaborated.h"

namespace blysk::lyon_device {

template <class Formats>
using type = lyon<netlist::on_wires<Formats>>;

template <class Q>
std::vector<port> ports(const selection& asked) {
  return with_formats<Q>(asked, []<class Formats>() { return ports_of<type<Formats>>(); });
}

template <class Q>
std::unique_ptr<netlist::elaborated> elaborate(const selection& asked, double clock_period_ns) {
  return with_formats<Q>(asked, [&]<class Formats>() {
    return std::make_unique<netlist::elaborated>(std::make_unique<type<Formats>>("lyon"), clock_period_ns);
  });
}

}  // namespace blysk::lyon_device
