// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/slopes.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>

#include "tb/golden/errors.h"

namespace blysk::claims {

using namespace golden;

double slope_error(double slope, slope_axis axis, int first) {
  double result = 0;
  for (int n = first; n <= 1000; ++n) {
    const double a = slope * n - 0.5;
    const auto f = [a](double c) { return std::max(0.0, quadratic(a, c)); };
    const peak error =
        axis == slope_axis::whole
            ? largest_absolute_error(f, n, 0)
            : largest_relative_error(
                  f, n,
                  epicentre_edge(axis == slope_axis::epicentre ? epicentre::level_056 : epicentre::inflection,
                                 n));
    result = std::max(result, error.value);
  }
  return result;
}

double best_slope(slope_axis axis, int first) {
  constexpr int kBits = 14;  // of the slope: four digits
  return boost::math::tools::brent_find_minima([=](double slope) { return slope_error(slope, axis, first); },
                                               0.1, 1.2, kBits)
      .first;
}

}  // namespace blysk::claims
