// SPDX-License-Identifier: Apache-2.0
/// The lobes as the seeds print them, and searches over them. No code is shared with tb/golden.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace blysk::claims::literal {

inline const double kPi = std::acos(-1.0);

inline double blinn(double n, double c) {
  return std::pow(c, n);
}
inline double schlick(double n, double c) {
  return c / (n - n * c + c);
}
inline double reading_a(double n, double c) {
  return c / (0.5 * n * (1 - c * c) + n - n * c + c);
}
inline double reading_b(double n, double c) {
  return c / (0.5 * n * (1 - c) * (1 - c) + n - n * c + c);
}
inline double reading_c(double n, double c) {
  return c / (0.5 * n * (1 - std::cos(std::pow(std::acos(c), 2))) + n - n * c + c);
}
inline double reading_d(double n, double c) {
  return c / (0.5 * std::pow(n * (1 - c), 2) + n - n * c + c);
}
/// [T] table 3.2.
inline double reading_e(double n, double a, double c) {
  return std::pow(c, a) / (n - n * c + c);
}
inline double cosine_quadratic(double n, double c) {
  const double root = (n + 1) / 3 * (c - 1) + 1;
  return root > 0 ? root * root : 0;
}

/// [P] (9), its limit at n = 1.
inline double exact_a(double n) {
  const double t = std::sqrt((n - 1) / n);
  return n == 1 ? 0 : (std::pow(t, n - 1) - 1) / (t - 1);
}
inline double published_a(double n) {
  return 0.786 * n + 0.5;
}
inline double derived_a(double n) {
  return 2 * (1 - std::exp(-0.5)) * n - 0.5;
}
inline double parabola(double a, double c) {
  return std::max(0.0, a * (c * c - c) + c);
}

/// Cosine at which the parabola ends; 0 if nowhere in [0, 1].
inline double parabola_root(double a) {
  return a > 1 ? 1 - 1 / a : 0;
}

/// Where an epicentre ends.
enum class zone { level_060, level_056, inflection };
inline constexpr std::array kZones{zone::level_060, zone::level_056, zone::inflection};

inline const char* key_of(zone z) {
  return z == zone::level_060 ? "060" : z == zone::level_056 ? "056" : "infl";
}

inline double edge_of(zone z, double n) {
  if (z == zone::inflection) return std::cos(std::atan(1 / std::sqrt(n - 1)));
  return std::exp(std::log(z == zone::level_060 ? 0.6 : 0.56) / n);
}

/// The inflection point of n = 1 lies at 90 degrees.
inline int first_of(zone z) {
  return z == zone::inflection ? 2 : 1;
}

/// Largest f at even steps of [low, high], and the top of the parabola through the largest and its neighbours: where f is
/// smooth, exact to the fourth power of the step.
template <class F>
double largest(const F& f, double low, double high, int steps = 400) {
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(steps) + 1);
  for (int i = 0; i <= steps; ++i) values.push_back(f(low + (high - low) * i / steps));
  const auto top = static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
  if (top == 0 || top + 1 == values.size()) return values[top];
  const double bend = values[top - 1] - 2 * values[top] + values[top + 1];
  const double slope = values[top + 1] - values[top - 1];
  return bend < 0 ? values[top] - slope * slope / (8 * bend) : values[top];
}

/// Largest relative error against c^n from the edge to the axis.
template <class F>
double relative_error(const F& f, double n, double edge, int steps = 400) {
  return largest([&](double c) { return std::abs(f(c) / std::pow(c, n) - 1); }, edge, 1, steps);
}

struct peak {
  double value;
  int n;
};

/// Largest value over n = first..last, at the first n that no later one passes by more than 1e-11 of it.
template <class F>
peak over_n(int first, int last, const F& f) {
  peak result{f(first), first};
  for (int n = first + 1; n <= last; ++n) {
    const double value = f(n);
    if (value > result.value + 1e-11 * std::abs(result.value)) result = {value, n};
  }
  return result;
}

/// "n in 1..3, 7" where met(n) holds, "no n".
template <class Met>
std::string where(int first, int last, const Met& met) {
  std::string result;
  for (int n = first; n <= last; ++n) {
    if (!met(n)) continue;
    int end = n;
    while (end < last && met(end + 1)) ++end;
    result += (result.empty() ? "n in " : ", ") + std::to_string(n);
    if (end > n) result += ".." + std::to_string(end);
    n = end;
  }
  return result.empty() ? "no n" : result;
}

}  // namespace blysk::claims::literal
