// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/speed.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

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

double recorded_price(std::string_view device, std::string_view column) {
  const auto fields_of = [](const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream text(line);
    for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
    return fields;
  };
  std::ifstream file(BLYSK_PRICE_CSV);
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> heads = fields_of(line);
  const auto place = static_cast<std::size_t>(std::ranges::find(heads, column) - heads.begin());
  while (std::getline(file, line)) {
    const std::vector<std::string> fields = fields_of(line);
    if (!fields.empty() && fields.front() == device && place < fields.size()) return std::stod(fields[place]);
  }
  throw std::runtime_error("no " + std::string(column) + " of " + std::string(device) +
                           " in " BLYSK_PRICE_CSV);
}

double recorded_cost(const std::string& device, const char* part, const char* key) {
  const std::string path = BLYSK_TABLES "/" + device + "/cost_q8.json";
  std::ifstream file(path);
  try {
    return nlohmann::json::parse(file).at(part).at(key).get<double>();
  } catch (const nlohmann::json::exception&) {
    throw std::runtime_error("no " + std::string(part) + "." + key + " in " + path);
  }
}

}  // namespace blysk::claims
