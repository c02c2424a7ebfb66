// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/errors.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <vector>

namespace blysk::golden {
namespace {

constexpr int kSteps = 200;
constexpr double kTail = 40;  // e^-40 < 5e-18: c^n is zero to double precision beside its peak

std::vector<double> sample_cosines(double n, double low, double high) {
  std::vector<double> result{low, high};
  for (int i = 0; i <= kSteps; ++i) {
    const double step = static_cast<double>(i) / kSteps;
    result.push_back(low + (high - low) * step);
    result.push_back(1 - std::min(1.0, kTail / n) * step);
  }
  std::erase_if(result, [&](double c) { return c < low || c > high; });
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()),
               result.end());  // or a sample could neighbour itself
  return result;
}

}  // namespace

peak largest(const std::function<double(double)>& f, double n, double low, double high) {
  const std::vector<double> cosines = sample_cosines(n, low, high);
  std::vector<double> values(cosines.size());
  std::transform(cosines.begin(), cosines.end(), values.begin(), f);
  peak result{-std::numeric_limits<double>::infinity(), low};
  const auto take = [&](const peak& candidate) {
    if (candidate.value > result.value) result = candidate;
  };
  for (std::size_t i = 0; i < cosines.size(); ++i) {
    const std::size_t left = i > 0 ? i - 1 : i;
    const std::size_t right = std::min(i + 1, cosines.size() - 1);
    if (!(values[i] >= values[left] && values[i] >= values[right])) continue;
    take({values[i], cosines[i]});
    const auto [cosine, negated] =
        boost::math::tools::brent_find_minima([&](double c) { return -f(c); }, cosines[left], cosines[right],
                                              std::numeric_limits<double>::digits / 2);
    take({-negated, cosine});
  }
  return result;
}

std::string_view name_of(epicentre which) {
  switch (which) {
    case epicentre::level_060:
      return "c^n >= 0.6";
    case epicentre::level_056:
      return "c^n >= 0.56";
    case epicentre::inflection:
      break;
  }
  return "up to the inflection point";
}

double epicentre_edge(epicentre which, double n) {
  switch (which) {
    case epicentre::level_060:
      return std::pow(0.6, 1 / n);
    case epicentre::level_056:
      return std::pow(0.56, 1 / n);
    case epicentre::inflection:
      break;
  }
  return std::sqrt((n - 1) / n);
}

std::function<double(double)> clamped_lobe(lobe which, double n) {
  return with_lobe(which, n, [](const auto& f) {
    return std::function<double(double)>([f](double c) { return std::max(0.0, f(c)); });
  });
}

peak largest_absolute_error(const std::function<double(double)>& f, double n, double low) {
  return largest([&](double c) { return std::abs(f(c) - blinn(n, c)); }, n, low, 1);
}

peak largest_relative_error(const std::function<double(double)>& f, double n, double low) {
  return largest([&](double c) { return std::abs(f(c) / blinn(n, c) - 1); }, n, low, 1);
}

double rms_error(const std::function<double(double)>& f, double n) {
  const auto square = [&](double c) {
    const double error = f(c) - blinn(n, c);
    return error * error;
  };
  using quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
  const double tail = std::max(0.0, 1 - kTail / n);
  const double integral =
      quadrature::integrate(square, tail, 1.0, 12, 1e-9) + quadrature::integrate(square, 0.0, tail, 12, 1e-9);
  return std::sqrt(integral);
}

}  // namespace blysk::golden
