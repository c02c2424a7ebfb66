// SPDX-License-Identifier: Apache-2.0
#include "tb/certificate/specification.h"

#include <fmt/format.h>

#include <bit>
#include <regex>
#include <sstream>

#include "tb/cost/cost_row.h"
#include "tb/usage_error.h"

namespace blysk {
namespace {

/// The line with numbers in the place of {F+4} and the like.
std::string in_bits(const std::string& line, int fraction) {
  static const std::regex bits(R"(\{(#?)(\d*)F(/2)?([+-]\d+)?\})");
  std::string made;
  auto rest = line.cbegin();
  for (std::sregex_iterator each(line.begin(), line.end(), bits), end; each != end; ++each) {
    const std::smatch& found = *each;
    made.append(rest, found[0].first);
    int number = found[2].length() == 0 ? fraction : std::stoi(found[2]) * fraction;
    if (found[3].length() != 0) number /= 2;
    if (found[4].length() != 0) number += std::stoi(found[4]);
    made += std::to_string(
        found[1].length() == 0 ? number : static_cast<int>(std::bit_width(static_cast<unsigned>(number))));
    rest = found[0].second;
  }
  return made.append(rest, line.cend());
}

/// \return  false for a line that is none of those that specification.h names
bool take_line(const std::string& word, const std::string& rest, specification& to) {
  static const std::regex named(R"((\w+) = (.+))");
  static const std::regex memory(R"((\w+) ~ (\w+) within ([0-9.]+)(?: from (\d+))?)");
  static const std::regex curve(
      R"((\w+) \+ (\w+) \* (\w+) ~ (\w+) = (\w+) from (\S+) over (\S+), half ([^ ,]+)(, relative)?)");
  static const std::regex groups(R"((\w+)((?: \d+(?:/\d+)?)+)(?: where (.+))?)");
  static const std::regex valued_if(R"((.+): (\S+)(?: if (.+))?)");
  static const std::regex sign(R"((.+) >= 0)");
  std::smatch found;
  const auto matches = [&](const std::regex& form) { return std::regex_match(rest, found, form); };
  if (word == "let" && matches(named)) {
    to.lets.emplace_back(found[1], found[2]);
  } else if (word == "number" && matches(named)) {
    to.numbers.emplace_back(found[1], found[2]);
  } else if (word == "memory" && matches(memory)) {
    to.memories.push_back({found[1], found[2], found[3], found[4].length() == 0 ? 0 : std::stoul(found[4])});
  } else if (word == "words" && matches(sign)) {
    to.words.push_back(found[1]);
  } else if (word == "curve" && matches(curve)) {
    to.curves.push_back({found[1], found[2], found[3], found[4], found[5], found[6], found[7], found[8],
                         found[9].length() != 0});
  } else if (word == "groups" && matches(groups)) {
    address_groups made{.net = found[1], .firsts = {}, .condition = found[3]};
    std::istringstream firsts(found[2]);
    for (std::string first; firsts >> first;) made.firsts.push_back(first);
    to.groups.push_back(made);
  } else if (word == "case" && matches(valued_if)) {
    to.cases.push_back({found[1], found[2], found[3]});
  } else if (word == "where" && matches(valued_if)) {
    to.ways.push_back({found[1], found[2], found[3]});
  } else if (word == "fact") {
    to.facts.push_back(rest);
  } else if (word == "claim") {
    to.claims.push_back(rest);
  } else if (word == "hint") {
    to.hints.push_back(rest);
  } else if (word == "split") {
    to.splits.push_back(rest);
  } else {
    return false;
  }
  return true;
}

bool is_pair(const std::vector<exact_case>& cases) {
  if (cases.size() != 2) return false;
  const std::string& first = cases[0].condition;
  const std::string name = first.substr(0, first.find(' '));
  return first == name + " >= 0" && cases[1].condition == name + " <= 0";
}

}  // namespace

specification read_specification(const std::string& path, int fraction) {
  specification read;
  std::istringstream lines(cost::read_text(path));
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    const std::size_t blank = line.find(' ');
    const std::string rest = blank == std::string::npos ? "" : in_bits(line.substr(blank + 1), fraction);
    if (!take_line(line.substr(0, blank), rest, read)) {
      throw file_error(path, number,
                       fmt::format("'{}' is unknown, expected one of the lines that "
                                   "tb/certificate/specification.h names",
                                   line));
    }
    if (line.starts_with("hint ") && rest.find(" / ") != std::string::npos &&
        rest.find(" <> 0") == std::string::npos)
      throw file_error(path, number, "divides by what may be 0, expected the condition { WHAT <> 0 }");
  }
  if (!is_pair(read.cases))
    throw file_error(path, 0, "has other cases than NAME >= 0 and NAME <= 0, which leave out nothing");
  return read;
}

}  // namespace blysk
