// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/measure/over_exponents.h"

#include "tb/claims/words.h"

namespace blysk::claims {

using namespace golden;

std::string_view key_of(epicentre where) {
  switch (where) {
    case epicentre::level_060:
      return "060";
    case epicentre::level_056:
      return "056";
    case epicentre::inflection:
      break;
  }
  return "infl";
}

void add_worst(figures& into, const std::string& key, const worst& w) {
  into[key] = w.value;
  into[key + "_n"] = static_cast<double>(w.n);
}

void add_worst_percent(figures& into, const std::string& key, const worst& w) {
  add_worst(into, key, {in_percent(w.value), w.n});
}

std::string exponents_where(int first, int last, const std::function<bool(int)>& holds) {
  std::vector<bool> members(static_cast<std::size_t>(last), false);
  for (int n = first; n <= last; ++n) members[static_cast<std::size_t>(n) - 1] = holds(n);
  const std::string result = ranges(members);
  return result == "none" ? "no n" : std::string("n in ").append(result);
}

}  // namespace blysk::claims
