// SPDX-License-Identifier: Apache-2.0
#include "tb/port.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace blysk {

std::string port::text() const {
  return fmt::format("{}{}{}", number.empty() ? "" : number + ": ", note,
                     carries ? ", " + carries->note() : "");
}

std::vector<port> of_role(const std::vector<port>& ports, port::role role) {
  std::vector<port> found;
  std::ranges::copy_if(ports, std::back_inserter(found),
                       [role](const port& each) { return each.is == role; });
  return found;
}

std::string column_names(const std::vector<port>& ports, port::role role) {
  std::string names;
  for (const port& each : of_role(ports, role)) names += (names.empty() ? "" : ",") + each.column;
  return names;
}

protocol protocol_of(const std::vector<port>& ports) {
  const auto count = [&](port::role role) { return std::ranges::count(ports, role, &port::is); };
  if (count(port::role::clock) != 1 || count(port::role::reset) != 1 || count(port::role::valid) != 1)
    return protocol::none;
  if (count(port::role::start) == 1 && count(port::role::ready) == 1 && count(port::role::strobe) == 0)
    return protocol::handshake;
  const auto trailing = std::ranges::count_if(ports, [](const port& each) {
    return each.is == port::role::strobe && each.edge == write_edge::trailing;
  });
  const bool all_strobed = std::ranges::all_of(ports, [&](const port& data) {
    return data.is != port::role::data || std::ranges::any_of(ports, [&](const port& each) {
             return each.is == port::role::strobe && each.writes == data.name;
           });
  });
  const bool has_strobes =
      count(port::role::strobe) == count(port::role::data) && trailing == 1 && all_strobed;
  return has_strobes ? protocol::strobes : protocol::none;
}

std::size_t find_role(const std::vector<port>& ports, port::role role) {
  const auto found = std::ranges::find(ports, role, &port::is);
  if (found == ports.end()) throw std::logic_error("a device lacks a port that its protocol needs");
  return static_cast<std::size_t>(found - ports.begin());
}

}  // namespace blysk
