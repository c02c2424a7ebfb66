// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/wave_changes.h"

#include <charconv>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "tb/line_reader.h"

namespace blysk::harness {

wave_changes::wave_changes(const std::string& vcd) {
  line_reader lines(vcd, "a waveform (VCD)");
  std::vector<std::string> scopes{""};
  bool is_header = true;
  bool is_comment = false;
  std::uint64_t now = 0;
  while (lines.next()) {
    const std::string line(lines.text());
    std::istringstream words(line);
    std::string first, second;
    words >> first >> second;
    if (is_header) {
      if (first == "$scope") {
        std::string name;
        words >> name;
        scopes.push_back(scopes.back() + name + ".");
      } else if (first == "$upscope") {
        if (scopes.size() == 1) throw lines.error("no scope is open, expected $scope before it");
        scopes.pop_back();
      } else if (first == "$var") {
        std::string width, code, name;
        words >> width >> code >> name;
        codes_[scopes.back() + name] = code;
      } else if (first == "$comment") {
        is_comment = true;
      } else if (first == "$end") {
        is_comment = false;
      } else if (is_comment) {
        comment_.push_back(line);
      }
      is_header = first != "$enddefinitions";
    } else if (first.starts_with('#')) {
      const auto [end, error] = std::from_chars(first.data() + 1, first.data() + first.size(), now);
      if (error != std::errc{} || end != first.data() + first.size())
        throw lines.error("is no time, expected an integer behind #");
    } else if (first.starts_with('b') || first.starts_with('r')) {
      changes_[second][now] = first.substr(1);
    } else if (first.starts_with('0') || first.starts_with('1')) {
      changes_[first.substr(1)][now] = first.substr(0, 1);
    }
  }
  if (is_header) throw lines.error("the header has no end, expected $enddefinitions");
}

const std::string& wave_changes::at(const std::string& name, std::uint64_t time) const {
  const auto code = codes_.find(name);
  if (code == codes_.end()) throw std::invalid_argument("the waveform has no signal " + name);
  const auto found = changes_.find(code->second);
  if (found == changes_.end() || found->second.begin()->first > time)
    throw std::invalid_argument("the waveform has no value of " + name + " at that time");
  return std::prev(found->second.upper_bound(time))->second;
}

}  // namespace blysk::harness
