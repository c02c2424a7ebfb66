// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "rtl_sysc/devices/quadratic_interpolation/quadratic_interpolation.h"
#include "tb/device.h"
#include "tb/netlist/elaborated.h"

namespace blysk::quadratic_interpolation_device {

template <class Q>
std::vector<port> ports(const selection&) {
  return ports_of<quadratic_interpolation<quadratic_interpolation_formats<Q>>>();
}

template <class Q>
std::unique_ptr<netlist::elaborated> elaborate(const selection&, double clock_period_ns) {
  using type = quadratic_interpolation<quadratic_interpolation_formats<Q>>;
  return std::make_unique<netlist::elaborated>(std::make_unique<type>("quadratic_interpolation"),
                                               clock_period_ns);
}

}  // namespace blysk::quadratic_interpolation_device
