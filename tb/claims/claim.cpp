// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/claim.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace blysk::golden {

std::string number(double value, int digits) {
  if (std::abs(value) < kRounding) return "0";  // the rest is rounding, and compilers may differ in it
  std::ostringstream out;
  out.precision(digits);
  out << value;
  return out.str();
}

std::string percent(double value, int digits) {
  return (std::abs(value) < kRounding ? "0" : number(100 * value, digits)) + " %";
}

std::string verdict_of(bool holds) {
  return std::string(holds ? kHolds : kFails);
}

namespace {

std::string mixed_verdict(const std::vector<reading>& readings, std::string_view mixed) {
  std::string names;
  bool all = true;
  for (const auto& r : readings) {
    all = all && r.holds;
    if (r.holds) append(names, ", ", r.name);
  }
  if (all || names.empty()) return verdict_of(all);
  return std::string(mixed) + " " + names;
}

}  // namespace

std::string verdict_of(const std::vector<reading>& readings) {
  return mixed_verdict(readings, std::string(kAmbiguous) + ": holds for");
}

std::string verdict_of_parts(const std::vector<reading>& parts) {
  return mixed_verdict(parts, std::string(kPartly) + ":");
}

bool rounds_to(double measured, double printed, int decimals) {
  // Half a unit of the last printed place; the sum of two decimal roundings adds a few roundoffs.
  return std::abs(measured - printed) <= 0.5 * std::pow(10.0, -decimals) * (1 + 1e-9);
}

std::string ranges(const std::vector<bool>& members) {
  std::string result;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (!members[i]) continue;
    std::size_t last = i;
    while (last + 1 < members.size() && members[last + 1]) ++last;
    append(result, ", ", std::to_string(i + 1));
    if (last > i) result += ".." + std::to_string(last + 1);
    i = last;
  }
  return result.empty() ? "none" : result;
}

std::string markdown(const std::vector<std::vector<std::string>>& rows) {
  std::string result;
  const auto line = [&](const std::vector<std::string>& cells) {
    result += "|";
    for (const auto& cell : cells) {
      result += " ";
      for (const char letter : cell) {
        if (letter == '|') result += '\\';  // or it would end the cell
        result += letter;
      }
      result += " |";
    }
    result += "\n";
  };
  line(rows.front());
  line(std::vector<std::string>(rows.front().size(), "---"));
  std::for_each(rows.begin() + 1, rows.end(), line);
  return result;
}

}  // namespace blysk::golden
