// SPDX-License-Identifier: Apache-2.0
#include "tb/specular/pipelined.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <sstream>
#include <utility>

#include "tb/read_number.h"

namespace blysk::specular {
namespace {

/// The stages that cuts make of the levels, the longest first.
std::vector<int> stages_of(const std::vector<pipeline_level>& levels, std::uint64_t cuts) {
  std::vector<int> stages;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    if (level == 0 || ((cuts >> level) & 1) != 0) stages.push_back(0);
    stages.back() += levels[level].ps;
  }
  std::ranges::sort(stages, std::greater{});
  return stages;
}

}  // namespace

int longest_stage(const std::vector<pipeline_level>& levels, std::uint64_t cuts) {
  return stages_of(levels, cuts).front();
}

std::vector<std::uint64_t> balanced_cuts(const std::vector<pipeline_level>& levels) {
  std::vector<std::uint64_t> best(levels.size());
  std::vector<std::vector<int>> best_stages(levels.size());
  for (std::uint64_t cuts = 0; cuts >> levels.size() == 0; cuts += 2) {  // there is no cut 0
    std::vector<int> made = stages_of(levels, cuts);
    const std::size_t place = made.size() - 1;
    if (!best_stages[place].empty() && made >= best_stages[place]) continue;
    best[place] = cuts;
    best_stages[place] = std::move(made);
  }
  return best;
}

const std::vector<std::uint64_t>& pipelined::balanced() const {
  std::call_once(is_balanced_, [this] { balanced_ = balanced_cuts(levels_); });
  return balanced_;
}

int pipelined::fewest_stages() const {
  const int shortest = longest_stage(levels_, balanced().back());
  const auto found = std::ranges::find_if(
      balanced(), [&](std::uint64_t cuts) { return longest_stage(levels_, cuts) == shortest; });
  return static_cast<int>(found - balanced().begin()) + 1;
}

pipeline_cuts pipelined::cuts(const selection& asked) const {
  const std::size_t count = levels_.size();
  const std::string& stages = asked.value("stages");
  const std::string& list = asked.value("cuts");
  if (!stages.empty() && !list.empty())
    throw std::invalid_argument("--stages and --cuts exclude each other, expected one of them");
  if (list.empty()) {
    const auto number = stages.empty() ? fewest_stages() : read_integer(stages);
    if (!number || *number < 1 || *number > static_cast<std::int64_t>(count))
      throw std::invalid_argument(
          fmt::format("--stages is {}, expected 1 to {} with device {}", stages, count, name()));
    return {balanced()[static_cast<std::size_t>(*number) - 1]};
  }
  std::uint64_t places = 0;
  int last = 0;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    const auto cut = read_integer(word);
    if (!cut || *cut <= last || *cut >= static_cast<std::int64_t>(count))
      throw std::invalid_argument(fmt::format(
          "--cuts is {}, expected rising numbers from 1 to {} with commas between", list, count - 1));
    last = static_cast<int>(*cut);
    places |= std::uint64_t{1} << last;
  }
  if (list.back() == ',')
    throw std::invalid_argument(fmt::format("--cuts is {}, expected a number behind the last comma", list));
  return {places};
}

std::vector<port> pipelined::with_stages(std::vector<port> ports, const selection& asked) const {
  const int last = static_cast<int>(levels_.size()) - 1;
  ports.at(find_role(ports, port::role::valid)).settling_cycles = 1 + cuts(asked).between(0, last);
  return ports;
}

std::string pipelined::figure() const {
  return other().figure() + ", with registers between its blocks";
}

std::vector<option> pipelined::options() const {
  std::vector<option> all = device_of_same_values::options();
  all.push_back({.name = "stages",
                 .help = "stages of the pipeline; without it as many as the shortest clock needs",
                 .is_wired = true});
  all.push_back({.name = "cuts",
                 .help = "levels that begin with registers, such as 2,3,5, in the place of --stages",
                 .is_wired = true});
  return all;
}

void pipelined::check(const selection& asked) const {
  device_of_same_values::check(asked);
  if (asked.is_for() == purpose::hardware) cuts(asked);
}

std::map<std::string, std::string> pipelined::canonical(const selection& asked) const {
  std::map<std::string, std::string> values = asked.values();
  if (asked.is_preset() || asked.is_for() == purpose::formula) return values;
  const pipeline_cuts found = cuts(asked);
  const int last = static_cast<int>(levels_.size()) - 1;
  const int stages = 1 + found.between(0, last);
  std::string& list = values["cuts"];
  std::string& count = values["stages"];
  list.clear();
  count.clear();
  if (found.places == balanced()[static_cast<std::size_t>(stages) - 1]) {
    if (stages != fewest_stages()) count = std::to_string(stages);
    return values;
  }
  for (int cut = 1; cut <= last; ++cut) {
    if (found.between(cut - 1, cut) > 0) list += fmt::format("{}{}", list.empty() ? "" : ",", cut);
  }
  return values;
}

std::string pipelined::words(const selection& asked) const {
  const std::string own = other().words(of_other(asked));
  if (asked.is_for() == purpose::formula) return own;
  std::string places;
  const pipeline_cuts found = cuts(asked);
  const int count = static_cast<int>(levels_.size());
  for (int cut = 1; cut < count; ++cut) {
    if (found.between(cut - 1, cut) > 0) places += fmt::format("{}{}", places.empty() ? "" : ",", cut);
  }
  return fmt::format("{}{}{} stage{}{}", own, own.empty() ? "" : ", ", 1 + found.between(0, count - 1),
                     places.empty() ? "" : "s", places.empty() ? "" : ", cuts " + places);
}

}  // namespace blysk::specular
