// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/test/second.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "tb/catch.h"

namespace blysk::claims {
namespace {

/// The texts that differ from `printed` in one digit.
std::vector<std::string> mutants_of(const std::string& printed) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    if (std::isdigit(static_cast<unsigned char>(printed[i])) == 0) continue;
    for (char digit = '0'; digit <= '9'; ++digit) {
      if (digit == printed[i]) continue;
      result.push_back(printed);
      result.back()[i] = digit;
    }
  }
  return result;
}

void check_row(const claim& c, const std::map<std::string, std::string>& list, const figures& second) {
  std::set<std::string> derived;
  for (const auto& [key, spec] : placeholders(c.measured)) {
    if (std::ranges::find(c.regenerated_only, key) != c.regenerated_only.end()) continue;
    CAPTURE(key);
    REQUIRE(second.contains(key));
    derived.insert(key);
    const std::string& printed = list.at(key);
    const figure& value = second.at(key);
    CAPTURE(printed, print(value, spec), print(value, ""));
    CHECK(agrees(printed, value, spec));
    for (const auto& mutant : mutants_of(printed)) {
      CAPTURE(mutant);
      CHECK_FALSE(agrees(mutant, value, spec));
    }
  }
  CHECK(second.size() == derived.size());
}

}  // namespace

bool agrees(const std::string& printed, const figure& second, const std::string& spec) {
  return print(second, spec) == printed;
}

void check_rows(std::string_view test, const std::map<std::string, figures>& second) {
  REQUIRE(std::ranges::find(kHolders, test) != kHolders.end());
  const figure_list list = load_figures(BLYSK_MEASURED_JSON);
  std::set<std::string> held;
  for (const auto& section : all_claims()) {
    for (const claim& c : section.rows) {
      if (c.held_by != test) continue;
      CAPTURE(c.id);
      held.insert(c.id);
      REQUIRE(second.contains(c.id));
      REQUIRE(list.contains(c.id));
      check_row(c, list.at(c.id), second.at(c.id));
    }
  }
  CHECK(!held.empty());
  for (const auto& [id, unused] : second) {
    CAPTURE(id);
    CHECK(held.contains(id));
  }
}

}  // namespace blysk::claims
