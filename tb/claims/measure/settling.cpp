// SPDX-License-Identifier: Apache-2.0
// [P] fig. 3: the strobe against the transients, as `blysk settle` found them: docs/tables/settling.csv.
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tb/claims/figure.h"

namespace blysk::claims {
namespace {

/// A line of the table: device, format, smallest gap and so on; got and expected are the last two.
std::vector<std::vector<std::string>> settling_rows() {
  std::ifstream file(BLYSK_SETTLING_CSV);
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    auto& row = rows.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) row.push_back(field);
    if (row.size() != 11) throw std::runtime_error("a row of " BLYSK_SETTLING_CSV " has not 11 fields");
  }
  if (rows.empty()) throw std::runtime_error("no rows in " BLYSK_SETTLING_CSV);
  return rows;
}

double gap_of(const std::vector<std::vector<std::string>>& rows, const std::string& device,
              const std::string& format) {
  for (const auto& row : rows) {
    if (row[0] == device && row[1] == format) return std::stod(row[2]);
  }
  throw std::runtime_error("no gap of " + device + " " + format + " in " BLYSK_SETTLING_CSV);
}

}  // namespace

void measure_settling(measurements& into) {
  into["P9"] = [] {
    const auto rows = settling_rows();
    double right = 0;
    for (const auto& row : rows) right += row[9] == row[10] ? 1 : 0;
    return figures{
        {"rows", static_cast<double>(rows.size())},       {"right", right},
        {"q8", gap_of(rows, "quadratic", "q8")},          {"q12", gap_of(rows, "quadratic", "q12")},
        {"q16", gap_of(rows, "quadratic", "q16")},        {"rom_q8", gap_of(rows, "quadratic-rom", "q8")},
        {"rom_q12", gap_of(rows, "quadratic-rom", "q12")}};
  };
}

}  // namespace blysk::claims
