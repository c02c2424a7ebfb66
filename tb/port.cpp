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

std::size_t find_role(const std::vector<port>& ports, port::role role) {
  const auto found = std::ranges::find(ports, role, &port::is);
  if (found == ports.end()) throw std::logic_error("a device lacks a port that its protocol needs");
  return static_cast<std::size_t>(found - ports.begin());
}

}  // namespace blysk
