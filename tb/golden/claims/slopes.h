// SPDX-License-Identifier: Apache-2.0
/// Which slope of the line a = slope n - 1/2 is best, and on which axis.
#pragma once

namespace blysk::golden {

enum class slope_axis {
  whole,       ///< largest absolute error over cos in [0, 1], clamped
  epicentre,   ///< largest relative error where c^n >= 0.56
  inflection,  ///< largest relative error up to the inflection point
};

/// Largest error over n = 2, 5, 10, 20, 50, 100, 200, 500, 1000.
double slope_error(double slope, slope_axis axis);

/// The slope in [0.1, 1.2] with the least slope_error, to four digits.
double best_slope(slope_axis axis);

}  // namespace blysk::golden
