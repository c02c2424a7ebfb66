// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "rtl_sysc/devices/iterative.h"
#include "rtl_sysc/devices/rational/rational.h"
#include "tb/devices/rational/fit.h"
#include "tb/netlist/elaborated.h"

namespace blysk::rational_iterative_device {

template <class Formats>
using type = rational<Formats, iterative_device<Formats>>;

template <class Q>
std::vector<port> ports(const selection& asked) {
  return rational_device::with_formats<Q>(asked, []<class Formats>() { return ports_of<type<Formats>>(); });
}

template <class Q>
std::unique_ptr<netlist::elaborated> elaborate(const selection& asked, double clock_period_ns) {
  return rational_device::with_formats<Q>(asked, [&]<class Formats>() {
    return std::make_unique<netlist::elaborated>(std::make_unique<type<Formats>>("rational_iterative"),
                                                 clock_period_ns);
  });
}

}  // namespace blysk::rational_iterative_device
