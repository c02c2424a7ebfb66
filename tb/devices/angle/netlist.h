// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "rtl_sysc/devices/angle/angle.h"
#include "tb/device.h"
#include "tb/devices/angle/kinds.h"
#include "tb/netlist/elaborated.h"

namespace blysk::angle_device {

template <class Q>
std::vector<port> ports(const selection& asked) {
  return with_formats<Q>(asked, []<class Formats>() { return ports_of<angle<Formats>>(); });
}

template <class Q>
std::unique_ptr<netlist::elaborated> elaborate(const selection& asked, double clock_period_ns) {
  return with_formats<Q>(asked, [&]<class Formats>() {
    using type = angle<Formats>;
    const std::uint64_t level = level_of(asked);
    const auto powers = static_cast<std::uint64_t>(powers_of(asked));
    const auto words = std::make_unique<typename type::contents>();  // too large for the stack
    words->powers = powers_of(asked);
    fill_powers(words->rom1, powers, Formats::address_bits, Q::frac);
    fill_factors(words->rom2, level, powers, Formats::factor_bits);
    if constexpr (Formats::has_energy)
      fill_energy(words->rom_energy, *energy_of(asked), level, powers, Formats::energy_bits);
    return std::make_unique<netlist::elaborated>(std::make_unique<type>("angle", *words), clock_period_ns);
  });
}

}  // namespace blysk::angle_device
