// SPDX-License-Identifier: Apache-2.0
/// How far a lobe is from c^n.
#pragma once

#include <array>
#include <functional>
#include <string_view>

#include "tb/golden/lobe.h"

namespace blysk::golden {

/// A largest value and the cosine at which it lies.
struct peak {
  double value;
  double cos;
};

/// Largest value of f over [low, high].
/// Looks at 200 cosines in even steps and 200 in even steps of n (1 - c) up to 40, where c^n has vanished,
/// then refines every local maximum among them by Brent's method: exact where f has one maximum between
/// neighbours.
peak largest(const std::function<double(double)>& f, double n, double low, double high);

/// Where a highlight's epicentre ends: three thresholds are in use.
enum class epicentre {
  level_060,   ///< c^n >= 0.6, [T] fig. 2.3
  level_056,   ///< c^n >= 0.56, [T] fig. 2.7
  inflection,  ///< up to the inflection point of cos^n, [A] table 1
};

inline constexpr std::array kEpicentres{epicentre::level_060, epicentre::level_056, epicentre::inflection};

std::string_view name_of(epicentre which);

/// Smallest cosine of the epicentre: 0.6^(1/n), 0.56^(1/n) or sqrt((n-1)/n).
double epicentre_edge(epicentre which, double n);

/// A lobe as a function of the cosine, negative values set to zero as the device's clamp does.
std::function<double(double)> clamped_lobe(lobe which, double n);

/// |f - c^n| at its largest over [low, 1].
peak largest_absolute_error(const std::function<double(double)>& f, double n, double low);

/// |f - c^n| / c^n at its largest over [low, 1]; low must keep c^n above zero.
peak largest_relative_error(const std::function<double(double)>& f, double n, double low);

/// sqrt(integral from 0 to 1 of (f - c^n)^2 dc).
double rms_error(const std::function<double(double)>& f, double n);

}  // namespace blysk::golden
