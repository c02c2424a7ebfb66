// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/plots/figure.h"

#include <cmath>

namespace blysk::claims::plots {

using namespace golden;

std::vector<double> steps(double first, double last, int count) {
  std::vector<double> result;
  for (int i = 0; i <= count; ++i) result.push_back(first + (last - first) * i / count);
  return result;
}

std::vector<double> exponents(int first, int last) {
  std::vector<double> result;
  for (const double logarithm : steps(std::log(first), std::log(last), 160)) {
    const double n = std::round(std::exp(logarithm));
    if (result.empty() || n > result.back()) result.push_back(n);
  }
  return result;
}

curve over_angle(std::string title, lobe which, double n) {
  return {std::move(title), [=](double degrees) { return evaluate(which, n, std::cos(degrees * kDegree)); }};
}

curve over_exponents(std::string title, lobe which,
                     const std::function<double(const error_summary&)>& metric) {
  return {std::move(title),
          [=](double n) { return metric(errors_of(which)[static_cast<std::size_t>(n) - 1]); }};
}

curve relative(std::string title, lobe which, epicentre where) {
  return over_exponents(std::move(title), which, [=](const error_summary& e) {
    return 100 * e.relative[static_cast<std::size_t>(where)].value;
  });
}

curve energy(std::string title, lobe which, lobe_axis axis, double degrees) {
  return {std::move(title), [=](double n) { return lobe_reflectance(which, n, axis, degrees); }};
}

}  // namespace blysk::claims::plots
