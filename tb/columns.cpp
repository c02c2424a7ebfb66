// SPDX-License-Identifier: Apache-2.0
#include "tb/columns.h"

#include <algorithm>
#include <iterator>

namespace blysk {

column::column(storage kind) {
  switch (kind) {
    case storage::u8:
      elements_.emplace<std::vector<std::uint8_t>>();
      break;
    case storage::u16:
      elements_.emplace<std::vector<std::uint16_t>>();
      break;
    case storage::u32:
      elements_.emplace<std::vector<std::uint32_t>>();
      break;
    case storage::i32:
      elements_.emplace<std::vector<std::int32_t>>();
      break;
    case storage::i64:
      elements_.emplace<std::vector<std::int64_t>>();
      break;
    case storage::f64:
      elements_.emplace<std::vector<double>>();
      break;
  }
}

columns::columns(const std::vector<storage>& layout) : columns_(layout.begin(), layout.end()) {}

columns::columns(const std::vector<port>& ports, port::role role) {
  for (const port& each : of_role(ports, role)) columns_.emplace_back(storage_of(*each.carries));
}

bool columns::has_layout(const std::vector<storage>& kinds) const {
  return std::ranges::equal(columns_, kinds, {}, &column::kind);
}

std::vector<storage> columns::layout() const {
  std::vector<storage> kinds;
  std::ranges::transform(columns_, std::back_inserter(kinds), &column::kind);
  return kinds;
}

}  // namespace blysk
