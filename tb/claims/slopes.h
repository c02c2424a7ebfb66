// SPDX-License-Identifier: Apache-2.0
/// Which slope of the line a = slope n - 1/2 is best, and on which axis.
#pragma once

namespace blysk::claims {

enum class slope_axis {
  whole,       ///< largest absolute error over cos in [0, 1], clamped
  epicentre,   ///< largest relative error where c^n >= 0.56
  inflection,  ///< largest relative error up to the inflection point
};

/// Largest error over n = first..1000. Axis inflection has no n = 1: c^1 has no such point.
double slope_error(double slope, slope_axis axis, int first);

/// The slope in [0.1, 1.2] with the least slope_error, to four digits.
double best_slope(slope_axis axis, int first);

}  // namespace blysk::claims
