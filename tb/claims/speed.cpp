// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/speed.h"

#include <fstream>
#include <stdexcept>
#include <string>

namespace blysk::claims {

double recorded_speed(std::string_view name) {
  std::ifstream file(BLYSK_SPEED_CSV);
  std::string start("\"");
  start.append(name).append("\",");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(start)) return std::stod(line.substr(line.rfind(',') + 1));
  }
  throw std::runtime_error("no row " + std::string(name) + " in " BLYSK_SPEED_CSV);
}

}  // namespace blysk::claims
