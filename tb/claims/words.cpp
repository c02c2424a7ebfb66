// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/words.h"

#include <algorithm>

#include "tb/claims/figure.h"

namespace blysk::claims {

std::string number(double value, int digits) {
  return print(value, std::string(".").append(std::to_string(digits)).append("g"));
}

std::string percent(double value, int digits) {
  return number(in_percent(value), digits) + " %";
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

}  // namespace blysk::claims
