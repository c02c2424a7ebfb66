// SPDX-License-Identifier: Apache-2.0
/// Numbers and lists as words of a page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace blysk::claims {

/// \param digits  significant digits; below kRounding it is "0"
std::string number(double value, int digits = 3);
std::string percent(double value, int digits = 3);

/// Adds an item to a list in words: the separator before all but the first, then the item's parts.
template <class... Parts>
void append(std::string& list, std::string_view separator, const Parts&... parts) {
  if (!list.empty()) list += separator;
  ((list += parts), ...);
}

/// "1..17, 25": the members of [1, size] whose entry is true; "none" if there are none.
std::string ranges(const std::vector<bool>& members);

/// A table in Markdown: the first row is the head.
std::string markdown(const std::vector<std::vector<std::string>>& rows);

}  // namespace blysk::claims
