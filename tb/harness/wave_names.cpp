// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/wave_names.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "tb/line_reader.h"

namespace blysk::harness {

namespace {

/// Words of a line, between blanks.
std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\v\f\r";
  std::vector<std::string_view> words;
  for (std::size_t begin = line.find_first_not_of(kBlanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlanks, end);
  }
  return words;
}

/// The name without a range at its end.
std::string_view without_range(std::string_view name) {
  if (!name.ends_with(']')) return name;
  const std::size_t range = name.rfind('[');
  if (range == std::string_view::npos || range == 0) return name;
  const std::string_view between = name.substr(range + 1, name.size() - range - 2);
  const bool is_range =
      !between.empty() && between.find_first_not_of("0123456789:") == std::string_view::npos;
  return is_range ? name.substr(0, range) : name;
}

}  // namespace

std::unordered_set<std::string> declared_signals(const std::string& vcd) {
  line_reader lines(vcd, "a waveform (VCD)");
  std::unordered_set<std::string> signals;
  std::vector<std::string> scopes{""};
  while (lines.next()) {
    // Every writer of such files begins a line with each of these keywords.
    const std::vector<std::string_view> words = words_of(lines.text());
    if (words.empty()) continue;
    if (words[0] == "$enddefinitions") return signals;
    if (words[0] == "$scope" && words.size() >= 3) {
      scopes.push_back(scopes.back() + std::string(words[2]) + ".");
    } else if (words[0] == "$upscope") {
      if (scopes.size() == 1) throw lines.error("no scope is open, expected $scope before it");
      scopes.pop_back();
    } else if (words[0] == "$var" && words.size() >= 5) {
      signals.insert(scopes.back() + std::string(without_range(words[4])));
    }
  }
  throw lines.error("the header has no end, expected $enddefinitions");
}

row_count rows_of(const std::string& layout, const std::unordered_set<std::string>& signals) {
  line_reader lines(layout, "a layout (.gtkw)");
  row_count count;
  while (lines.next()) {
    std::string_view row = lines.text();
    if (row.starts_with("+{")) {
      const std::size_t end = row.find("} ");
      if (end != std::string_view::npos) row.remove_prefix(end + 2);
    }
    const bool is_shown = signals.contains(std::string(without_range(row)));
    const bool is_other =
        row.empty() || std::string_view("[*@-#^+").find(row.front()) != std::string_view::npos;
    if (is_shown) {
      ++count.shown;
    } else if (!is_other) {
      ++count.unknown;
    }
  }
  return count;
}

}  // namespace blysk::harness
