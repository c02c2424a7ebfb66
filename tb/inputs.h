// SPDX-License-Identifier: Apache-2.0
/// Stimuli for tests: every input, random ones, corners; in batches that stay in the cache.
///
/// The first ports that a device names as enumerated take the values that are asked for. The others run through their
/// codes alongside, in a sequence that visits all of them.
#pragma once

#include <cstdint>
#include <functional>

#include "tb/device.h"

namespace blysk {

using use_batch = std::function<void(const columns&)>;

/// Collects writes to a device and hands them on in batches of 4096.
class batcher {
 public:
  batcher(const selection& asked, use_batch use);

  /// Appends a write.
  /// \param codes  of the enumerated ports
  void add(std::span<const std::int64_t> codes);

  /// Hands on what has been collected; last.
  void flush();

 private:
  std::vector<port> data_;
  use_batch use_;
  columns rows_;
  std::size_t size_ = 0;
  std::uint32_t sequence_ = 1;
};

/// How many inputs for_all_inputs() has.
std::uint64_t input_count(const selection& asked);

/// Every combination of legal codes of the enumerated ports.
void for_all_inputs(const selection& asked, const use_batch& use);

/// `count` writes, the enumerated ports' codes even over their legal ranges.
void for_random_inputs(const selection& asked, std::uint64_t count, std::uint64_t seed, const use_batch& use);

/// All codes of the enumerated ports but the last, with the last one's codes within `reach` of its ends and of the
/// device's corners.
void for_corner_inputs(const selection& asked, std::int64_t reach, const use_batch& use);

}  // namespace blysk
