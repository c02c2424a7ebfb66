// SPDX-License-Identifier: Apache-2.0
/// Measurements over every exponent, each made once per run and shared by rows, tables and plots.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tb/golden/errors.h"
#include "tb/golden/reflectance.h"

namespace blysk::claims {

using golden::epicentre;
using golden::kEpicentres;
using golden::lobe;
using golden::lobe_axis;
using golden::peak;

inline constexpr int kMaxExponent = 1000;

/// The lobes that stand for c^n itself, without a normalisation.
inline constexpr std::array kApproximations{
    lobe::schlick,
    lobe::schlick_modified,
    lobe::schlick_modified_a,
    lobe::schlick_modified_b,
    lobe::schlick_modified_c,
    lobe::quadratic_exact,
    lobe::quadratic_published,
    lobe::quadratic_derived,
    lobe::cosine_quadratic,
    lobe::lyon_2,
    lobe::lyon_4,
    lobe::lyon_8,
    lobe::gx,
    lobe::rational,
};

/// Errors of one lobe, clamped to [0, 1] as the devices do, at one exponent.
struct error_summary {
  peak whole;  ///< largest absolute error over [0, 1]
  double rms;
  std::array<peak, kEpicentres.size()> relative;  ///< by epicentre
  std::array<peak, kEpicentres.size()> absolute;
};

/// Entry n - 1 for n = 1..1000.
const std::vector<error_summary>& errors_of(lobe which);

/// The same for the angle-based lobe at Q = 0.5, k = 1..5, as a function of the cosine.
const std::vector<error_summary>& errors_of_angle(int k);

/// A value and the exponent at which it lies.
struct worst {
  double value;
  int n;
};

/// "0.1 (n = 3)" and "10 % (n = 3)".
std::string at(const worst& w, int digits = 3);
std::string percent_at(const worst& w);

/// Largest metric(n) for n in [first, last], at the first n that no later one surpasses by more than kNoise of it: what
/// is flat in n would else peak where the mathematical library's last digit says.
inline constexpr double kNoise = 1e-11;  // a hundred times n roundoffs, which c^n passes on
template <class Metric>
worst worst_over(int first, int last, const Metric& metric) {
  worst result{metric(first), first};
  for (int n = first + 1; n <= last; ++n) {
    const double value = metric(n);
    if (value > result.value + kNoise * std::abs(result.value)) result = {value, n};
  }
  return result;
}

/// 1, but 2 for the inflection point: that of n = 1 lies at 90 degrees, where no relative error exists.
int first_exponent(epicentre where);

/// Largest relative or absolute error of a lobe in an epicentre, and over the whole range, over the
/// exponents.
worst worst_relative(lobe which, epicentre where, int last = kMaxExponent);
worst worst_absolute(lobe which, epicentre where, int last = kMaxExponent);
worst worst_whole(lobe which, int last = kMaxExponent);

}  // namespace blysk::claims
