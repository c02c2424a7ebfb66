// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "rtl_sysc/devices/cosine_quadratic/cosine_quadratic.h"
#include "tb/device.h"
#include "tb/devices/cosine_quadratic/kinds.h"
#include "tb/netlist/elaborated.h"

namespace blysk::cosine_quadratic_device {

template <class Q>
std::vector<port> ports(const selection& asked) {
  return with_formats<Q>(
      asked, []<class Formats>() { return ports_of<cosine_quadratic<netlist::on_wires<Formats>>>(); });
}

template <class Q>
std::unique_ptr<netlist::elaborated> elaborate(const selection& asked, double clock_period_ns) {
  return with_formats<Q>(asked, [&]<class Formats>() {
    return std::make_unique<netlist::elaborated>(
        std::make_unique<cosine_quadratic<netlist::on_wires<Formats>>>("cosine_quadratic", factor_of(asked)),
        clock_period_ns);
  });
}

}  // namespace blysk::cosine_quadratic_device
