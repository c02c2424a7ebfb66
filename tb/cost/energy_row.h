// SPDX-License-Identifier: Apache-2.0
/// How often the nets of a mapped device change for a result, and what energy its cells take, as energy/energy.sh measures it.
#pragma once

#include <map>
#include <string>

namespace blysk::cost {

struct switching {
  double toggles = 0;  ///< changes of cells' outputs for a result, the clock's apart
  double pj = 0;  ///< internal and switching energy of the cells for a result, the clock's pins included, pJ
};

/// The same netlist with its cells' delays, and without any.
struct switching_pair {
  switching with_delays, without;
};

struct energy_use {
  switching_pair whole;
  std::map<std::string, switching_pair> blocks;
};

/// A row docs/tables/<identifier>/energy_<format>.json.
struct energy_row {
  std::string device, format, digest;
  std::map<std::string, std::string> options;
  std::map<std::string, energy_use> stimuli;  ///< "random", "line", "sphere"
};

/// \throws usage_error for text that holds no such row
energy_row parse_energy_row(const std::string& path, const std::string& text);

}  // namespace blysk::cost
