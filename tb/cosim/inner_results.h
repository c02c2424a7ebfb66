// SPDX-License-Identifier: Apache-2.0
/// Rows that reach all of a device with one inner result.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "tb/engine.h"
#include "tb/inputs.h"

namespace blysk::cosim {

/// Rows and what the bit-accurate model gives for them.
struct vectors {
  columns in;
  columns expected;
};

/// A device of this kind: it has one inner result, which depends on the enumerated ports alone, and every result depends on
/// that and on one other data port. With those ports at their largest codes the results tell all inner results apart, which
/// is checked. So all codes of the enumerated ports there cover the path to the inner result, and all codes of the others at
/// every inner result that occurs cover the rest.
class inner_results {
 public:
  /// \param asked  outlives the object
  /// \throws std::invalid_argument if the device has not one inner result and others
  explicit inner_results(const selection& asked);

  /// Columns of the results that are no inner ones.
  const std::vector<std::size_t>& outer() const { return outer_; }

  vectors with_results(const columns& in);

  /// The same rows, the ports that are not enumerated at their largest codes.
  columns at_largest(columns in) const;

  /// The results of a row, without the inner one.
  std::vector<std::int64_t> outer_results(const columns& out, std::size_t row) const;

  /// Whether some legal code gives these results with the other ports at their largest.
  bool occurs(const std::vector<std::int64_t>& results) const { return seen_.contains(results); }

  /// Every code of the ports that are not enumerated, all at the same distance from their smallest, at every inner result.
  void for_others(const use_batch& use) const;

 private:
  void find_columns();
  void find_inner_results();

  const selection& asked_;
  std::vector<port> data_;
  std::unique_ptr<engine> model_;
  std::size_t inner_ = 0;                                     // column of the inner result
  std::vector<std::size_t> outer_;                            // columns of the others
  std::map<std::int64_t, std::vector<std::int64_t>> inputs_;  // of every inner result
  std::set<std::vector<std::int64_t>> seen_;                  // the results they give at the largest codes
};

}  // namespace blysk::cosim
