// SPDX-License-Identifier: Apache-2.0
#include "tb/cost/error_sums.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tb/vector_clones.h"

namespace blysk::cost {
namespace {

constexpr double kFloor = 1e-200;  // products of smaller numbers would be subnormal, and slow
constexpr double kHalfStep = 0.5 / 255;

double total(const lanes& of) {
  return std::accumulate(of.begin(), of.end(), 0.0);
}

}  // namespace

/// Largest values of the points that one call of add_range() takes.
struct range_peaks {
  lanes abs{}, relative{}, step{};
};

/// To nearest, ties up; x + 0.5 would round up what is just below a tie.
[[gnu::always_inline]] inline double nearest(double x) {
  const double whole = std::floor(x);
  return whole + (x - whole >= 0.5 ? 1.0 : 0.0);
}

/// A point into its lane.
[[gnu::always_inline]] inline void add_point(const point_block& block, double ulp, double ulps, std::size_t i,
                                             std::size_t lane, error_sums& sums, range_peaks& peaks) {
  const double exact = block.exact[i];
  const double device = block.device[i];
  const double error = device * ulp - exact;
  const double size = std::fabs(error);
  sums.abs[lane] += size;
  sums.signed_error[lane] += error;
  sums.square[lane] += error * error;
  sums.energy[lane] += exact * exact;
  peaks.abs[lane] = size > peaks.abs[lane] ? size : peaks.abs[lane];
  const double off = std::fabs(device - nearest(exact * ulps));
  for (std::size_t k = 0; k < sums.ulps.size(); ++k)
    sums.ulps[k][lane] += off == static_cast<double>(k) ? 1.0 : 0.0;
  const bool counts = exact * ulps >= 0.5;
  const double relative = (counts ? size : 0.0) / (counts ? exact : 1.0);
  sums.relative[lane] += relative;
  sums.relative_points[lane] += counts ? 1.0 : 0.0;
  peaks.relative[lane] = relative > peaks.relative[lane] ? relative : peaks.relative[lane];
  const double step = std::fabs(nearest(device * ulp * 255) - nearest(exact * 255));
  peaks.step[lane] = step > peaks.step[lane] ? step : peaks.step[lane];
}

/// Points first..last - 1, the first of which has one before it in the block.
BLYSK_VECTOR_CLONES void add_range(const point_block& block, std::size_t first, std::size_t last,
                                   error_sums& sums, range_peaks& peaks) {
  const double ulp = std::ldexp(1.0, -block.bits);
  const double ulps = std::ldexp(1.0, block.bits);
  error_sums local = sums;
  range_peaks local_peaks = peaks;
  std::size_t i = first;
  for (; i + kLanes <= last; i += kLanes) {
#pragma omp simd
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      add_point(block, ulp, ulps, i + lane, lane, local, local_peaks);
      local.falls[lane] += block.device[i + lane] < block.device[i + lane - 1] ? 1.0 : 0.0;
    }
  }
  for (std::size_t lane = 0; i < last; ++i, ++lane) {
    add_point(block, ulp, ulps, i, lane, local, local_peaks);
    local.falls[lane] += block.device[i] < block.device[i - 1] ? 1.0 : 0.0;
  }
  sums = local;
  peaks = local_peaks;
}

BLYSK_VECTOR_CLONES void multiply_range(const double* cosines, double* power, double* rest,
                                        std::size_t size) {
#pragma omp simd
  for (std::size_t i = 0; i < size; ++i) {
    const double product = power[i] * cosines[i];
    const double more = rest[i] * cosines[i] + __builtin_fma(power[i], cosines[i], -product);
    const double sum = product + more;
    power[i] = sum < kFloor ? 0 : sum;
    rest[i] = sum < kFloor ? 0 : more - (sum - product);
  }
}

void multiply(std::span<const double> cosines, std::span<double> power, std::span<double> rest) {
  multiply_range(cosines.data(), power.data(), rest.data(), cosines.size());
}

void add_points(const point_block& block, std::size_t first, std::size_t last, error_sums& sums) {
  if (first >= last) return;
  range_peaks peaks;
  const double ulp = std::ldexp(1.0, -block.bits);
  std::size_t from = first;
  if (from == 0) {
    add_point(block, ulp, std::ldexp(1.0, block.bits), 0, 0, sums, peaks);
    sums.falls[0] += block.device[0] < block.before ? 1.0 : 0.0;
    ++from;
  }
  add_range(block, from, last, sums, peaks);
  sums.points += static_cast<double>(last - first);
  sums.max_rel = std::max(sums.max_rel, std::ranges::max(peaks.relative));
  sums.max_step = std::max(sums.max_step, std::ranges::max(peaks.step));
  const double largest = std::ranges::max(peaks.abs);
  if (largest <= sums.max_abs) return;
  std::size_t at = first;
  while (std::fabs(block.device[at] * ulp - block.exact[at]) != largest) ++at;
  sums.max_abs = largest;
  sums.max_abs_n = block.n;
  sums.max_abs_cos = block.cosines[at];
}

void add_lit_points(const point_block& block, error_sums& sums) {
  const double least = std::ldexp(kHalfStep, block.bits);
  const std::size_t size = block.cosines.size();
  const auto is_lit = [&](std::size_t i) {
    return std::fabs(block.device[i]) >= least || block.exact[i] >= kHalfStep;
  };
  for (std::size_t first = 0; first < size; ++first) {
    if (!is_lit(first)) continue;
    std::size_t last = first + 1;
    while (last < size && is_lit(last)) ++last;
    add_points(block, first, last, sums);
    first = last;
  }
}

error_sums& error_sums::operator+=(const error_sums& more) {
  points += more.points;
  if (more.max_abs > max_abs) {
    max_abs = more.max_abs;
    max_abs_cos = more.max_abs_cos;
    max_abs_n = more.max_abs_n;
  }
  max_rel = std::max(max_rel, more.max_rel);
  max_step = std::max(max_step, more.max_step);
  const auto add = [](lanes& to, const lanes& from) {
    std::ranges::transform(to, from, to.begin(), std::plus<>());
  };
  add(abs, more.abs);
  add(signed_error, more.signed_error);
  add(square, more.square);
  add(energy, more.energy);
  add(relative, more.relative);
  add(relative_points, more.relative_points);
  for (std::size_t k = 0; k < ulps.size(); ++k) add(ulps[k], more.ulps[k]);
  add(falls, more.falls);
  return *this;
}

errors error_sums::result() const {
  errors e;
  if (points == 0) return e;
  e.points = static_cast<std::uint64_t>(points);
  e.max_abs_err = max_abs;
  e.max_abs_n = max_abs_n;
  e.max_abs_cos = max_abs_cos;
  e.mean_abs_err = total(abs) / points;
  e.bias = total(signed_error) / points;
  e.rms_err = std::sqrt(total(square) / points);
  e.max_rel_err = max_rel;
  e.relative_points = static_cast<std::uint64_t>(total(relative_points));
  e.mean_rel_err = e.relative_points == 0 ? 0 : total(relative) / total(relative_points);
  e.ulps[3] = e.points;
  for (std::size_t k = 0; k < ulps.size(); ++k) {
    e.ulps[k] = static_cast<std::uint64_t>(total(ulps[k]));
    e.ulps[3] -= e.ulps[k];
  }
  e.error_probability = static_cast<double>(e.points - e.ulps[0]) / points;
  e.falls = static_cast<std::uint64_t>(total(falls));
  e.nmse = total(energy) == 0 ? 0 : total(square) / total(energy);
  e.max_step = static_cast<int>(max_step);
  return e;
}

}  // namespace blysk::cost
