// SPDX-License-Identifier: Apache-2.0
/// Real numbers in 50 digits that Gappa has no formula of: what words of memories stand for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tb/golden/referee.h"

namespace blysk {

/// A number of an exponent: "exact_coefficient" of [P] (9); "power_at_root", c^n at the root (n - 2)/(n + 1) of the
/// cosine-quadratic, 0 up to n = 2; "rational_fall" and "rational_rise", r and d of the golden function rational.
using number_of_exponent = std::function<golden::referee(const golden::referee& n)>;
const std::map<std::string, number_of_exponent>& numbers_of();

/// A convex function that falls, with its derivative: "decay", e^-x; "half_power", 2^-x; "log_ratio",
/// (1 - log2(1 + x))/(1 - x) on [0, 1].
struct convex_curve {
  std::function<golden::referee(const golden::referee&)> value, slope;
};
const std::map<std::string, convex_curve>& convex_curves();

/// Lines of equal length one after the other: line i is begins[i] + changes[i] p, p in [0, 1], at from + (i + p) length.
struct stored_lines {
  std::vector<std::int64_t> begins, changes;
  int begin_frac, change_frac;  ///< fraction bits
  golden::referee from, length;
  golden::referee half = 0;  ///< what the begins have more, for a cut
};

/// What lies between two numbers, both of 40 digits and outside.
struct digits_range {
  std::string low, high;
  std::string text() const { return "[" + low + "," + high + "]"; }
};
digits_range outward(const golden::referee& low, const golden::referee& high);

struct errors_of_lines {
  digits_range absolute;  ///< line - curve
  digits_range relative;  ///< the same over the curve, which is above 0
};

/// On the segments first..last. The curve lies above each of its tangents and below its chords, so line - curve is least at an
/// end of a segment, and nowhere above what a tangent leaves; the tangent is taken where the curve is nearly as steep as the
/// line. Relative errors are those of each segment over the least or the largest value of the curve there.
errors_of_lines compare(const stored_lines& lines, const convex_curve& curve, std::size_t first,
                        std::size_t last);

/// Where the curve lies on the segments.
digits_range range_of_curve(const stored_lines& lines, const convex_curve& curve, std::size_t first,
                            std::size_t last);

}  // namespace blysk
