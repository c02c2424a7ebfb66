// SPDX-License-Identifier: Apache-2.0
/// Where a lobe begins and ends, by the bit-accurate model.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "tb/specular/specular.h"

namespace blysk::specular {

/// BRDF codes of one exponent.
struct lobe_ends {
  int n;
  bool has_root;         ///< the lobe ends within the range of the cosine
  std::int64_t at_peak;  ///< c = 1
  std::int64_t at_root;  ///< the code below the root or on it
  std::int64_t at_zero;  ///< c = 0
};

/// Of n = 1..1000.
/// \param asked  of a device that shades points
inline std::vector<lobe_ends> lobe_ends_of(const selection& asked) {
  constexpr int kMostN = 1000;
  const auto& device = dynamic_cast<const device_of_points&>(asked.of());
  const std::int64_t one = std::int64_t{1} << asked.fraction();
  columns in(device.ports(asked), port::role::data);
  columns out;
  in.resize(3 * kMostN);
  std::vector<lobe_ends> ends;
  for (int n = 1; n <= kMostN; ++n) {
    const double root = device.root(asked, n);
    const std::size_t first = 3 * ends.size();
    for (std::size_t k = 0; k < 3; ++k) in[kN].set(first + k, n);
    in[kCos].set(first, one);
    in[kCos].set(first + 1, static_cast<std::int64_t>(std::ldexp(root, asked.fraction())));
    in[kCos].set(first + 2, 0);
    ends.push_back({n, root != 0, 0, 0, 0});
  }
  device.make_bit(asked)->run(in, out);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    ends[i].at_peak = out[kBrdf].get(3 * i);
    ends[i].at_root = out[kBrdf].get(3 * i + 1);
    ends[i].at_zero = out[kBrdf].get(3 * i + 2);
  }
  return ends;
}

}  // namespace blysk::specular
