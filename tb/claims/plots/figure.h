// SPDX-License-Identifier: Apache-2.0
/// Figures as data: what is drawn, its axes and its caption.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tb/claims/sweep.h"

namespace blysk::claims::plots {

struct curve {
  std::string title;
  std::function<double(double)> y;
};

struct figure {
  std::string name;
  std::string caption;  ///< one line
  std::string x_label, y_label;
  std::string log_axes;  ///< "", "x", "y" or "xy"
  std::vector<double> x;
  std::vector<curve> curves;
  std::string y_range = "[*:*]";
  std::string style = "lines lw 2";
  std::function<double(double)> abscissa = std::identity();  ///< of a curve with a parameter
};

/// From `first` to `last` in so many even steps.
std::vector<double> steps(double first, double last, int count);

/// Whole exponents, in even steps of their logarithm.
std::vector<double> exponents(int first, int last);

inline constexpr double kDegree = boost::math::constants::degree<double>();

/// A lobe over the angle in degrees.
curve over_angle(std::string title, lobe which, double n);

curve over_exponents(std::string title, lobe which,
                     const std::function<double(const error_summary&)>& metric);

/// Largest relative error, %.
curve relative(std::string title, lobe which, epicentre where);

/// Reflectance over n.
curve energy(std::string title, lobe which, lobe_axis axis, double degrees);

std::vector<figure> article_figures();
std::vector<figure> thesis_figures();
std::vector<figure> own_figures();
std::vector<figure> hard_figures();

}  // namespace blysk::claims::plots
