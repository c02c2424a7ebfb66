// SPDX-License-Identifier: Apache-2.0
#include "tb/render/device_ports.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "tb/render/effects/specular.h"

namespace blysk::render {
namespace {

constexpr std::string_view kPointColumns = "n,cos,r,g,b";
enum : std::size_t { kN, kCos, kRed };

std::size_t find_column(const std::vector<port>& ports, const char* name) {
  const auto found = std::ranges::find(ports, name, &port::column);
  return found == ports.end() ? ports.size() : static_cast<std::size_t>(found - ports.begin());
}

}  // namespace

device_ports::device_ports(const selection& asked) : ports_(asked.of().ports(asked)) {
  const std::vector<port> results = of_role(ports_, port::role::result);
  const std::array names{"red", "green", "blue"};
  bool is_complete = column_names(ports_, port::role::data) == kPointColumns;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const std::size_t at = find_column(results, names[channel]);
    is_complete = is_complete && at < results.size();
    if (!is_complete) break;
    result_column_[channel] = at;
    result_format_[channel] = *results[at].carries;
  }
  if (!is_complete) {
    throw std::invalid_argument(
        fmt::format("device {} does not shade a point, expected one of the stimulus {}", asked.of().name(),
                    kPointColumns));
  }
  if (result_format_[0].integer > kTermIntegerBits) {
    throw std::invalid_argument(fmt::format("device {} puts out {} integer bits, expected at most {}",
                                            asked.of().name(), result_format_[0].integer, kTermIntegerBits));
  }
  cos_fraction_ = of_role(ports_, port::role::data)[kCos].carries->frac;
}

void device_ports::set(columns& writes, std::size_t row, int n, std::int64_t cosine,
                       const std::array<std::uint8_t, 3>& colour) const {
  writes[kN].set(row, n);
  writes[kCos].set(row, cosine);
  for (std::size_t channel = 0; channel < 3; ++channel) writes[kRed + channel].set(row, colour[channel]);
}

std::int64_t device_ports::term(const columns& results, std::size_t row, std::size_t channel,
                                const energy_share& by) const {
  const column& of = results[result_column_[channel]];
  if (of.kind() == storage::f64) return specular_term(by.real * of.real(row));
  const int fraction = result_format_[channel].frac;
  if (by.bits > 0) return normalised_term(of.get(row), fraction, by);
  return specular_term(of.get(row), fraction);
}

bool device_ports::is_limited() const {
  return std::ranges::all_of(result_format_, [](const wire_format& of) {
    return !of.is_signed && of.integer <= kColourIntegerBits;
  });
}

bool device_ports::is_dark(const columns& results, std::size_t row) const {
  return std::ranges::all_of(result_column_, [&](std::size_t at) { return results[at].real(row) == 0; });
}

std::int64_t lobe_table::begin(int n) {
  const auto known = known_.find(n);
  if (known != known_.end()) return known->second;
  constexpr std::int64_t kBatch = 4096;
  columns writes = ports_.make_writes();
  columns results;
  const std::int64_t end = ports_.one() + 1;
  for (std::int64_t first = 0; first < end; first += kBatch) {
    writes.resize(static_cast<std::size_t>(std::min(kBatch, end - first)));
    for (std::size_t i = 0; i < writes.size(); ++i)
      ports_.set(writes, i, n, first + static_cast<std::int64_t>(i), {255, 255, 255});
    law_.run(writes, results);
    for (std::size_t i = 0; i < writes.size(); ++i) {
      if (!ports_.is_dark(results, i)) return known_[n] = first + static_cast<std::int64_t>(i);
    }
  }
  return known_[n] = end;
}

}  // namespace blysk::render
