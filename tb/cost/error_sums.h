// SPDX-License-Identifier: Apache-2.0
/// Sums over points from which errors.h is computed.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tb/cost/errors.h"

namespace blysk::cost {

/// Points at one n, cosines increasing.
struct point_block {
  int n;
  int bits;                         ///< fraction bits of the BRDF
  std::span<const double> cosines;  ///< exact
  std::span<const double> exact;    ///< cos^n
  std::span<const double> device;   ///< BRDF in ulp
  double before;                    ///< BRDF in ulp at the cosine before the first, -inf if there is none
};

/// Eight sums side by side, so that the result does not depend on how many the processor adds at once.
inline constexpr std::size_t kLanes = 8;
using lanes = std::array<double, kLanes>;

struct error_sums {
  double points = 0;
  double max_abs = -1, max_abs_cos = 0;
  int max_abs_n = 0;
  double max_rel = 0, max_step = 0;
  lanes abs{}, signed_error{}, square{}, energy{};
  lanes relative{}, relative_points{};
  std::array<lanes, 3> ulps{};  // 0, 1, 2
  lanes falls{};

  error_sums& operator+=(const error_sums& more);
  errors result() const;
};

/// power, rest = (power + rest) cos for each point, normalised; 0 below 1e-200.
void multiply(std::span<const double> cosines, std::span<double> power, std::span<double> rest);

/// Adds the points first..last - 1 of the block.
void add_points(const point_block& block, std::size_t first, std::size_t last, error_sums& sums);

/// Adds those where the device or cos^n is at least half an 8-bit step.
void add_lit_points(const point_block& block, error_sums& sums);

}  // namespace blysk::cost
