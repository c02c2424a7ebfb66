// SPDX-License-Identifier: Apache-2.0
/// Inputs of a quadratic device, in batches that stay in the cache.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "tb/engine.h"

namespace blysk::cosim {

inline void append(batch& in, unsigned n, unsigned cos_delta, unsigned red, unsigned green, unsigned blue) {
  in.n.push_back(static_cast<std::uint16_t>(n));
  in.cos_delta.push_back(cos_delta);
  in.red_ks.push_back(static_cast<std::uint8_t>(red));
  in.green_ks.push_back(static_cast<std::uint8_t>(green));
  in.blue_ks.push_back(static_cast<std::uint8_t>(blue));
}

/// Collects writes and hands them on as batches of a few thousand.
template <class Use>
class batcher {
 public:
  explicit batcher(Use use) : use_(use) {}

  /// A write whose colours are taken from a sequence that visits all of them.
  void add(unsigned n, unsigned cos_delta) {
    colour_ = colour_ * 1664525u + 1013904223u;
    append(in_, n, cos_delta, colour_ >> 24, (colour_ >> 16) & 255u, (colour_ >> 8) & 255u);
    if (in_.size() == kSize) flush();
  }

  void flush() {
    if (in_.size() > 0) use_(in_);
    in_.resize(0);
  }

 private:
  static constexpr std::size_t kSize = 4096;

  Use use_;
  batch in_;
  std::uint32_t colour_ = 1;
};

/// Calls use(batch) with every n in 1..1000 at every cosine code 0..2^fraction.
template <class Use>
void for_all_inputs(int fraction, Use use) {
  batcher writes(use);
  for (unsigned n = 1; n <= 1000; ++n) {
    for (unsigned code = 0; code <= 1u << fraction; ++code) writes.add(n, code);
  }
  writes.flush();
}

/// Calls use(batch) with `count` writes, n and the cosine code even over their ranges.
template <class Use>
void for_random_inputs(int fraction, std::uint64_t count, std::uint64_t seed, Use use) {
  batcher writes(use);
  std::mt19937_64 random(seed);
  const std::uint64_t codes = (std::uint64_t{1} << fraction) + 1;
  for (; count > 0; --count) {
    const std::uint64_t bits = random();
    writes.add(static_cast<unsigned>(1 + ((bits & 0xffffu) * 1000 >> 16)),
               static_cast<unsigned>((bits >> 16 & 0xffffffffu) * codes >> 32));
  }
  writes.flush();
}

/// Calls use(batch) with all n at all codes within `reach` of 0, of 1 and of the upper root 1 - 1/a of the parabola
/// a (c^2 - c) + c, a = 0.78694 n - 1/2 (its lower root is 0). Up to the root the device's clamp is at work.
template <class Use>
void for_corner_inputs(int fraction, int reach, Use use) {
  batcher writes(use);
  const int one = 1 << fraction;
  for (unsigned n = 1; n <= 1000; ++n) {
    const double a = 0.786938680574733 * n - 0.5;
    const int root = static_cast<int>(std::lround(one * std::clamp(1 - 1 / a, 0.0, 1.0)));
    for (const int middle : {0, root, one}) {
      for (int code = std::max(0, middle - reach); code <= std::min(one, middle + reach); ++code) {
        writes.add(n, static_cast<unsigned>(code));
      }
    }
  }
  writes.flush();
}

}  // namespace blysk::cosim
