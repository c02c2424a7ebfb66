// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "tb/catch.h"
#include "tb/inputs.h"

namespace blysk::test {

/// Two engines that have to agree on every write, value by value.
class comparison {
 public:
  comparison(const selection& asked, std::unique_ptr<engine> tested, std::unique_ptr<engine> reference)
      : device_(asked.of()),
        ports_(device_.ports(asked)),
        tested_(std::move(tested)),
        reference_(std::move(reference)) {}

  void check(const columns& writes) {
    tested_->run(writes, from_tested_);
    reference_->run(writes, from_reference_);
    std::int64_t rows = 0;
    for (std::size_t row = 0; row < writes.size(); ++row) rows += device_.pixels(writes, row);
    REQUIRE(from_tested_.size() == static_cast<std::size_t>(rows));
    REQUIRE(from_reference_.size() == from_tested_.size());
    REQUIRE(from_tested_.width() == from_reference_.width());
    REQUIRE(from_tested_.width() > 0);
    writes_ += writes.size();
    if (from_tested_ == from_reference_) return;
    // The engines may store their results in integers of other widths.
    const auto results = of_role(ports_, port::role::result);
    std::size_t result = 0;
    for (std::size_t row = 0; row < writes.size(); ++row) {
      for (std::int64_t pixel = 0; pixel < device_.pixels(writes, row); ++pixel, ++result) {
        for (std::size_t i = 0; i < results.size(); ++i) {
          if (from_tested_[i].get(result) == from_reference_[i].get(result)) continue;
          std::string stimulus = column_names(ports_, port::role::data) + " =";
          for (const column& each : writes) stimulus.append(" ").append(std::to_string(each.get(row)));
          CAPTURE(stimulus, pixel, results[i].column, from_tested_[i].get(result),
                  from_reference_[i].get(result));
          FAIL("the engines differ");
        }
      }
    }
  }

  /// Compared so far.
  std::uint64_t writes() const { return writes_; }

 private:
  const device& device_;
  std::vector<port> ports_;
  std::unique_ptr<engine> tested_, reference_;
  columns from_tested_, from_reference_;
  std::uint64_t writes_ = 0;
};

constexpr std::int64_t kReach = 8;               // codes on either side of every corner
constexpr std::uint64_t kRandomWrites = 100000;  // seed 60553

/// Every input of a format that has no more than `limit`, of the others the corners and random ones.
inline void compare(comparison& compared, const selection& asked, std::uint64_t limit) {
  const auto check = [&](const columns& writes) { compared.check(writes); };
  const std::uint64_t inputs = input_count(asked);
  if (inputs <= limit) {
    for_all_inputs(asked, check);
    REQUIRE(compared.writes() == inputs);
    WARN("all inputs, " << inputs);
    return;
  }
  for_corner_inputs(asked, kReach, check);
  const std::uint64_t corners = compared.writes();
  REQUIRE(corners > 0);
  for_random_inputs(asked, kRandomWrites, 60553, check);
  REQUIRE(compared.writes() == corners + kRandomWrites);
  WARN(corners << " inputs at corners, " << kRandomWrites << " at random");
}

}  // namespace blysk::test
