// SPDX-License-Identifier: Apache-2.0
// Compiled once for each named format, BLYSK_FORMAT: what needs the types of the devices' netlists, of all devices in one
// object, since it is SystemC's own headers and blocks that take the compiler's time.
#include "tb/device.h"
#include "tb/devices/netlists.h"  // made by CMake from devices.def

namespace blysk {

template <class Q>
std::vector<port> ports_in(const selection& asked);
template <class Q>
std::unique_ptr<netlist::elaborated> elaborate_in(const selection& asked, double clock_period_ns);

template <>
std::vector<port> ports_in<BLYSK_FORMAT>(const selection& asked) {
#define BLYSK_DEVICE(identifier, called) \
  if (asked.of().name() == (called)) return identifier##_device::ports<BLYSK_FORMAT>(asked);
#include "tb/devices/devices.def"
#undef BLYSK_DEVICE
  throw std::logic_error("device " + asked.of().name() + " has no netlist");
}

template <>
std::unique_ptr<netlist::elaborated> elaborate_in<BLYSK_FORMAT>(const selection& asked,
                                                                double clock_period_ns) {
#define BLYSK_DEVICE(identifier, called) \
  if (asked.of().name() == (called))     \
    return identifier##_device::elaborate<BLYSK_FORMAT>(asked, clock_period_ns);
#include "tb/devices/devices.def"
#undef BLYSK_DEVICE
  throw std::logic_error("device " + asked.of().name() + " has no netlist");
}

}  // namespace blysk
