// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace blysk::claims {
namespace {

/// Two decimals and their difference add a few roundoffs.
constexpr double kDecimalNoise = 1e-9;

struct count {
  std::string reading;
  int met = 0, stated = 0;
  std::string names;  ///< of those that are met
};

}  // namespace

double number_of(std::string_view text) {
  double result = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
  if (error != std::errc() || end != text.data() + text.size())
    throw std::runtime_error("'" + std::string(text) + "' is no number");
  return result;
}

double unit_of(std::string_view printed) {
  const std::size_t exponent = std::min(printed.find('e'), printed.size());
  const std::size_t point = printed.find('.');
  const double scale = exponent == printed.size()
                           ? 0
                           : number_of(printed.substr(exponent + (printed[exponent + 1] == '+' ? 2 : 1)));
  const double decimals = point == std::string_view::npos ? 0 : static_cast<double>(exponent - point - 1);
  return std::pow(10.0, scale - decimals);
}

double miss_of(const demand& d, std::string_view printed) {
  const double distance = number_of(printed) - number_of(d.value);
  const double unit = d.law ? 1 : unit_of(d.value);
  switch (d.how) {
    case relation::at_most:
      return std::max(0.0, distance) / unit;
    case relation::at_least:
      return std::max(0.0, -distance) / unit;
    case relation::is:
      break;
  }
  return std::abs(distance) / unit;
}

bool met(const demand& d, std::string_view printed) {
  return miss_of(d, printed) <= (d.law ? 0 : 0.5 + kDecimalNoise);
}

judgement judge(const claim& c, const std::map<std::string, std::string>& printed) {
  if (c.stated.empty()) return {kOpen, c.open, "-"};
  std::vector<count> counts;
  double largest = -1;
  bool largest_met = true;
  std::string miss;
  const auto add_miss = [&](double value, bool is_met, const std::string& text) {
    // What is not met comes before what is: a law's miss has another unit than the rest.
    if (std::pair(!is_met, value) <= std::pair(!largest_met, largest)) return;
    largest = value;
    largest_met = is_met;
    miss = text;
  };
  for (const demand& d : c.stated) {
    auto found = std::find_if(counts.begin(), counts.end(),
                              [&](const count& each) { return each.reading == d.reading; });
    if (found == counts.end()) found = counts.insert(counts.end(), {d.reading, 0, 0, ""});
    const std::string& figure = printed.at(d.figure);
    if (d.of != 0) {
      const std::string& value = printed.at(d.largest_miss);
      found->met += static_cast<int>(number_of(figure));
      found->stated += d.of;
      add_miss(number_of(value), number_of(value) <= 0.5 + kDecimalNoise, value);
      continue;
    }
    const bool good = met(d, figure);
    const double value = miss_of(d, figure);
    ++found->stated;
    if (good) {
      ++found->met;
      if (!d.name.empty()) found->names += (found->names.empty() ? "" : ", ") + d.name;
    }
    add_miss(value, good,
             value == 0 ? "0"
             : d.law    ? fmt::format("{} for {}", figure, d.value)
                        : fmt::format("{} ({} for {})",
                                   value < 100 ? fmt::format("{:.2g}", value) : fmt::format("{:.0f}", value),
                                      figure, d.value));
  }

  bool all = true;
  bool none = true;
  const count* best = &counts.front();
  std::string whole;  // readings under which everything is met
  for (const count& each : counts) {
    all = all && each.met == each.stated;
    none = none && each.met == 0;
    if (each.met * best->stated > best->met * each.stated) best = &each;
    if (each.met == each.stated) whole += (whole.empty() ? "" : ", ") + each.reading;
  }
  if (all) return {kHolds, "", miss};
  if (none) return {kFails, "", miss};
  if (!whole.empty()) return {kDepends, "holds for " + whole, miss};
  std::string detail = fmt::format("{} of {}", best->met, best->stated);
  if (counts.size() > 1) detail += " for " + best->reading;
  if (!best->names.empty()) detail += " (" + best->names + ")";
  return {kPartly, detail, miss};
}

}  // namespace blysk::claims
