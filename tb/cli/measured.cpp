// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/measured.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "tb/cli/measured_tables.h"  // made by CMake from docs/tables

namespace blysk::cli {
namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> found;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, ',');) found.push_back(cell);
  return found;
}

}  // namespace

std::vector<worst_errors> measured_errors(const std::string& identifier) {
  std::vector<worst_errors> formats;
  for (const measured_table& table : kMeasuredTables) {
    if (table.identifier != identifier) continue;
    std::istringstream text{std::string(table.csv)};
    std::string line;
    std::getline(text, line);
    const std::vector<std::string> header = cells(line);
    const auto column = [&](std::string_view name) {
      const auto found = std::ranges::find(header, name);
      if (found == header.end())
        throw std::runtime_error("the errors of " + identifier + " have no column " + std::string(name));
      return static_cast<std::size_t>(found - header.begin());
    };
    const std::size_t format = column("format");
    const std::size_t n = column("n");
    const std::size_t whole = column("max_abs_err");
    const std::size_t epicentre = column("max_rel_err_060");
    while (std::getline(text, line)) {
      const std::vector<std::string> row = cells(line);
      if (formats.empty() || formats.back().format != row.at(format))
        formats.push_back({.format = row[format]});
      worst_errors& worst = formats.back();
      const auto exponent = static_cast<unsigned>(std::stoul(row.at(n)));
      if (const double value = std::stod(row.at(whole)); value > worst.whole) {
        worst.whole = value;
        worst.whole_n = exponent;
      }
      if (const double value = std::stod(row.at(epicentre)); value > worst.epicentre) {
        worst.epicentre = value;
        worst.epicentre_n = exponent;
      }
    }
  }
  return formats;
}

}  // namespace blysk::cli
