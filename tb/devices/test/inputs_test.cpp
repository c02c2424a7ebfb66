// SPDX-License-Identifier: Apache-2.0
// tb/inputs.h and the ports of a device: what every other test of the device rests on.
#include "tb/inputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "tb/catch.h"
#include "tb/devices/test/asked.h"

namespace {

using namespace blysk;
using test::asked_for;

std::vector<port> data_ports(const selection& asked) {
  return of_role(asked.of().ports(asked), port::role::data);
}

std::size_t enumerated_ports(const selection& asked) {
  return std::min(asked.of().enumerated(), data_ports(asked).size());
}

std::int64_t codes_of(const port& each) {
  return each.carries->max - each.carries->min + 1;
}

void require_legal(const columns& writes, const std::vector<port>& data) {
  REQUIRE(writes.width() == data.size());
  for (std::size_t i = 0; i < data.size(); ++i) {
    for (std::size_t row = 0; row < writes.size(); ++row) {
      const std::int64_t code = writes[i].get(row);
      if (code < data[i].carries->min || code > data[i].carries->max) {
        CAPTURE(data[i].name, row, code);
        FAIL("a code that is not legal");
      }
    }
  }
}

}  // namespace

TEST_CASE("no two inputs of one format run alike") {
  // Hardware with these two exchanged would give the same results.
  const selection asked = asked_for();
  const std::vector<port> data = data_ports(asked);
  constexpr std::uint64_t kRows = 1000;
  std::map<std::pair<std::size_t, std::size_t>, std::uint64_t> equal;
  for_random_inputs(asked, kRows, 1, [&](const columns& writes) {
    for (std::size_t i = 0; i < data.size(); ++i) {
      for (std::size_t k = i + 1; k < data.size(); ++k) {
        if (codes_of(data[i]) != codes_of(data[k])) continue;
        for (std::size_t row = 0; row < writes.size(); ++row)
          equal[{i, k}] +=
              writes[i].get(row) - data[i].carries->min == writes[k].get(row) - data[k].carries->min;
      }
    }
  });
  for (const auto& [pair, rows] : equal) {
    CAPTURE(data[pair.first].name, data[pair.second].name);
    // Twice what chance would make equal, and what few rows may have more.
    CHECK(rows <= 2 * kRows / static_cast<std::uint64_t>(codes_of(data[pair.first])) + 20);
  }
}

TEST_CASE("all inputs are all, each once") {
  const selection asked = asked_for();
  const std::vector<port> data = data_ports(asked);
  const std::size_t enumerated = enumerated_ports(asked);
  REQUIRE(enumerated > 0);
  std::vector<std::vector<bool>> alongside;
  alongside.reserve(data.size());
  for (const port& each : data)
    alongside.emplace_back(each.width() <= 20 ? static_cast<std::size_t>(codes_of(each)) : 0);
  // They come in the order of counting, the last port's codes fastest.
  constexpr std::uint64_t kEnough = 5'000'000;
  struct enough {};
  std::uint64_t count = 0;
  const auto check = [&](const columns& writes) {
    require_legal(writes, data);
    for (std::size_t row = 0; row < writes.size(); ++row, ++count) {
      std::uint64_t index = 0;
      for (std::size_t i = 0; i < enumerated; ++i) {
        index = index * static_cast<std::uint64_t>(codes_of(data[i])) +
                static_cast<std::uint64_t>(writes[i].get(row) - data[i].carries->min);
      }
      if (index != count) {
        CAPTURE(index, count);
        FAIL("an input is left out or comes twice");
      }
      for (std::size_t i = enumerated; i < data.size(); ++i) {
        const std::int64_t offset = writes[i].get(row) - data[i].carries->min;
        if (!alongside[i].empty()) alongside[i][static_cast<std::size_t>(offset)] = true;
      }
    }
    if (count >= kEnough) throw enough{};
  };
  if (input_count(asked) < kEnough) {
    for_all_inputs(asked, check);
    CHECK(count == input_count(asked));
  } else {
    CHECK_THROWS_AS(for_all_inputs(asked, check), enough);
    WARN("the first " << count << " of " << input_count(asked));
  }
  for (std::size_t i = enumerated; i < data.size(); ++i) {
    // A code comes again before the last one has come: the sequence needs many times as many rows as there are codes.
    if (count < 32 * alongside[i].size()) continue;
    CAPTURE(data[i].name);
    CHECK(std::ranges::count(alongside[i], false) == 0);
  }
}

TEST_CASE("random inputs are legal, even and repeatable") {
  const selection asked = asked_for();
  const std::vector<port> data = data_ports(asked);
  constexpr std::uint64_t kWrites = 100000;
  constexpr std::size_t kBins = 8;
  std::vector<std::array<std::uint64_t, kBins>> bins(data.size());
  std::uint64_t count = 0;
  std::uint64_t hash = 0;
  for_random_inputs(asked, kWrites, 1, [&](const columns& writes) {
    require_legal(writes, data);
    count += writes.size();
    for (std::size_t i = 0; i < data.size(); ++i) {
      for (std::size_t row = 0; row < writes.size(); ++row) {
        const std::int64_t offset = writes[i].get(row) - data[i].carries->min;
        ++bins[i].at(static_cast<std::size_t>(offset * std::int64_t{kBins} / codes_of(data[i])));
        hash = hash * 31 + static_cast<std::uint64_t>(offset);
      }
    }
  });
  CHECK(count == kWrites);
  for (std::size_t i = 0; i < data.size(); ++i) {
    const std::int64_t codes = codes_of(data[i]);
    if (codes < 64) continue;  // too few codes to fill the bins evenly
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      // Codes whose offset * 8 / codes is this bin, and the share of the writes that they deserve; the spread of a
      // binomial count is below its root, five of which are next to never passed: the seed is fixed.
      const std::int64_t of_bin =
          (static_cast<std::int64_t>(bin + 1) * codes + std::int64_t{kBins} - 1) / std::int64_t{kBins} -
          (static_cast<std::int64_t>(bin) * codes + std::int64_t{kBins} - 1) / std::int64_t{kBins};
      const double expected =
          static_cast<double>(kWrites) * static_cast<double>(of_bin) / static_cast<double>(codes);
      CAPTURE(data[i].name, bin, bins[i][bin], expected);
      CHECK(std::abs(static_cast<double>(bins[i][bin]) - expected) < 5 * std::sqrt(expected));
    }
  }
  std::uint64_t again = 0;
  std::uint64_t other = 0;
  for (const std::uint64_t seed : {std::uint64_t{1}, std::uint64_t{2}}) {
    std::uint64_t& sum = seed == 1 ? again : other;
    for_random_inputs(asked, kWrites, seed, [&](const columns& writes) {
      for (std::size_t i = 0; i < data.size(); ++i) {
        for (std::size_t row = 0; row < writes.size(); ++row)
          sum = sum * 31 + static_cast<std::uint64_t>(writes[i].get(row) - data[i].carries->min);
      }
    });
  }
  CHECK(again == hash);
  CHECK(other != hash);
}

TEST_CASE("corners hold the ends and what the device names") {
  const selection asked = asked_for();
  const std::vector<port> data = data_ports(asked);
  const std::size_t last = enumerated_ports(asked) - 1;
  const wire_format format = *data[last].carries;
  constexpr std::int64_t kReach = 2;
  std::map<std::vector<std::int64_t>, std::set<std::int64_t>> met;
  for_corner_inputs(asked, kReach, [&](const columns& writes) {
    require_legal(writes, data);
    for (std::size_t row = 0; row < writes.size(); ++row) {
      std::vector<std::int64_t> before;
      for (std::size_t i = 0; i < last; ++i) before.push_back(writes[i].get(row));
      met[before].insert(writes[last].get(row));
    }
  });
  std::uint64_t expected = 1;
  for (std::size_t i = 0; i < last; ++i) expected *= static_cast<std::uint64_t>(codes_of(data[i]));
  REQUIRE(met.size() == expected);
  for (const auto& [before, codes] : met) {
    std::vector<std::int64_t> corners = asked.of().corners(asked, before);
    corners.insert(corners.end(), {format.min, format.max});
    for (const std::int64_t corner : corners) {
      for (std::int64_t code = corner - kReach; code <= corner + kReach; ++code) {
        if (code < format.min || code > format.max || codes.contains(code)) continue;
        CAPTURE(before, corner, code);
        FAIL("a corner is missing");
      }
    }
  }
}

TEST_CASE("the ports are consistent", "[variants]") {
  const selection asked = asked_for();
  const std::vector<port> ports = asked.of().ports(asked);
  std::set<std::string> names, waves, columns_in, columns_out;
  for (const port& each : ports) {
    CAPTURE(each.name);
    CHECK(names.insert(each.name).second);
    CHECK(waves.insert(each.wave).second);
    CHECK_FALSE(each.note.empty());
    const bool is_number = each.is == port::role::data || each.is == port::role::result;
    REQUIRE(each.carries.has_value() == is_number);
    CHECK(each.column.empty() != is_number);
    if (is_number) {
      CHECK((each.is == port::role::data ? columns_in : columns_out).insert(each.column).second);
      CHECK(each.carries->min < each.carries->max);
      CHECK(each.width() <= 64);
    }
    if (each.is == port::role::strobe) {
      const auto written = std::ranges::find(ports, each.writes, &port::name);
      REQUIRE(written != ports.end());
      CHECK(written->is == port::role::data);
    }
  }
  CHECK_FALSE(columns_in.empty());
  CHECK_FALSE(columns_out.empty());
  CHECK(ports.at(find_role(ports, port::role::clock)).width() == 1);
  CHECK(enumerated_ports(asked) >= 1);
  CHECK(enumerated_ports(asked) <= columns_in.size());
}
