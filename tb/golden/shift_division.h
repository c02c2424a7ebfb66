// SPDX-License-Identifier: Apache-2.0
/// Division by a sum of shifts.   [T] 2.4
#pragma once

#include <cstdint>

namespace blysk::golden {

/// 1/k as a number of `steps` binary places, rounded to the nearest: the digits i_j of [T] (2.18), the last
/// one in bit 0. k = 1 gives 2^steps, one place more than the digits of a device hold: it needs no division.
/// \param k      run length in pixels, [1, 2^31]
/// \param steps  number of shifts, [1, 31]
constexpr uint32_t reciprocal_digits(uint32_t k, int steps) {
  return static_cast<uint32_t>(((uint64_t{2} << steps) / k + 1) / 2);
}

/// difference * reciprocal_digits / 2^steps: the increment that the shift and add device forms.
constexpr double shifted_quotient(double difference, uint32_t k, int steps) {
  return difference * reciprocal_digits(k, steps) / static_cast<double>(uint64_t{1} << steps);
}

}  // namespace blysk::golden
