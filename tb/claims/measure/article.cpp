// SPDX-License-Identifier: Apache-2.0
// [A]: the angle-based lobe and its normalisation.
#include "tb/claims/article.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tb/claims/figure.h"
#include "tb/claims/words.h"
#include "tb/golden/angle.h"

namespace blysk::claims {

using namespace golden;
namespace {

figures by_power(const std::array<double, kPowers>& values) {
  figures result;
  for (std::size_t k = 0; k < kPowers; ++k) result[fmt::format("k{}", k + 1)] = values[k];
  return result;
}

void measure_tables(measurements& into) {
  for (std::size_t row = 0; row < kLevels.size(); ++row) {
    into[fmt::format("A-T1-{}", kLevels[row])] = [row] {
      return by_power(table1(epicentre::inflection)[row]);
    };
    into[fmt::format("A-T2-{}", kLevels[row])] = [row] { return by_power(table2()[row]); };
  }
  into["A-T1"] = [] {
    figures result;
    for (const auto& [key, where] : {std::pair{"c060", epicentre::level_060},
                                     {"c056", epicentre::level_056},
                                     {"infl", epicentre::inflection}}) {
      const auto found = reproduce(table1(where), printed_cells(1));
      result[key] = static_cast<double>(found.met);
      result[fmt::format("{}_miss", key)] = found.largest_miss;
    }
    return result;
  };
  into["A-T2"] = [] {
    const auto found = reproduce(table2(), printed_cells(2));
    return figures{{"met", static_cast<double>(found.met)},
                   {"within", static_cast<double>(found.within_a_unit)},
                   {"miss", found.largest_miss}};
  };
  into["A2"] = [] {
    double result = 0;
    for (const auto& row : table2()) result = std::max(result, *std::ranges::max_element(row));
    return figures{{"largest", result}};
  };
  into["A3"] = [] { return figures{{"largest", *std::ranges::max_element(table2()[5])}}; };
  into["A1"] = [] {
    return figures{{"angle", table1(epicentre::inflection)[4][4]},
                   {"schlick", in_percent(worst_relative(lobe::schlick, epicentre::inflection).value)}};
  };
  into["A4"] = [] {
    figures result;
    const cells& errors = table1(epicentre::inflection);
    for (std::size_t k = 0; k < kPowers; ++k) {
      const auto least = std::ranges::min_element(errors, {}, [k](const auto& row) { return row[k]; });
      result[fmt::format("k{}", k + 1)] = kLevels[static_cast<std::size_t>(least - errors.begin())];
    }
    return result;
  };
}

/// The fitted coefficient with the further digits that figs. 7 and 8 show.
double figure_coefficient(double n, double k, double q) {
  if (q < 0.45) return 0.608 * n * (q - 0.193) / (2 * q + 2 * k) + 0.161445672 * n + 0.283821491376;
  return 0.743044 * q * (-0.013319008848 * k * n + 0.167 * n) / k + 0.167 * n + 0.245;
}

double formula_coefficient(double n, double k, double q) {
  return angle_coefficient_fitted(n, k, q);
}

struct fit_quality {
  double determination;  ///< R2
  double mean_error;     ///< mean absolute error
};

/// Quality of a fit over the training set for the levels in [low, high].
fit_quality quality(double low, double high, double (*fit)(double n, double k, double q)) {
  std::vector<double> exact;
  std::vector<double> fitted;
  for (const double q : kLevels) {
    if (q < low || q > high) continue;
    for (int k = 1; k <= kPowers; ++k) {
      for (const int n : kTrainingExponents) {
        exact.push_back(angle_coefficient_exact<double>(n, k, q));
        fitted.push_back(fit(n, k, q));
      }
    }
  }
  double mean = 0;
  for (const double y : exact) mean += y / static_cast<double>(exact.size());
  double residual = 0;
  double total = 0;
  double error = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    residual += (exact[i] - fitted[i]) * (exact[i] - fitted[i]);
    total += (exact[i] - mean) * (exact[i] - mean);
    error += std::abs(exact[i] - fitted[i]) / static_cast<double>(exact.size());
  }
  return {1 - residual / total, error};
}

void measure_figures(measurements& into) {
  const auto training = [](double q, const std::vector<int>& exponents) {
    figures result;
    for (const int n : exponents) result[fmt::format("n{}", n)] = angle_coefficient_exact<double>(n, 1, q);
    return result;
  };
  into["A-F4-0.5"] = [=] { return training(0.5, {kTrainingExponents.begin(), kTrainingExponents.end()}); };
  into["A-F4-0.1"] = [=] { return training(0.1, {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000}); };
  const auto determination = [](double low, double high) {
    return figures{{"formula", quality(low, high, formula_coefficient).determination},
                   {"figure", quality(low, high, figure_coefficient).determination}};
  };
  into["A-F7"] = [=] { return determination(0.05, 0.45); };
  into["A-F8"] = [=] { return determination(0.45, 0.95); };
  into["A-F6"] = [] {
    return figures{{"low", quality(0.05, 0.45, figure_coefficient).mean_error},
                   {"high", quality(0.45, 0.95, figure_coefficient).mean_error}};
  };
}

/// Calls use(n, k, q) over the training set.
template <class Use>
void over_training_set(const Use& use) {
  for (const double q : kLevels) {
    for (int k = 1; k <= kPowers; ++k) {
      for (const int n : kTrainingExponents) use(n, k, q);
    }
  }
}

void measure_reflectance(measurements& into) {
  into["A5"] = [] {
    double mirror = 0;
    double half = 0;
    double oblique = 0;
    over_training_set([&](int n, int k, double q) {
      if (n <= k) return;
      const double coefficient = formula_coefficient(n, k, q);
      mirror = std::max(mirror, angle_reflectance(n, k, q, coefficient, lobe_axis::mirror, 0));
      half = std::max(half, angle_reflectance(n, k, q, coefficient, lobe_axis::half_vector, 0));
      oblique = std::max(oblique, angle_reflectance(n, k, q, coefficient, lobe_axis::half_vector, 60));
    });
    return figures{{"mirror", mirror}, {"half", half}, {"oblique", oblique}};
  };
  into["A6"] = [] {
    const auto bare = [](int n, lobe_axis axis) { return angle_reflectance(n, 2, 0.5, 1, axis, 0); };
    std::vector<bool> above;
    for (int n = 1; n <= kMaxExponent; ++n) above.push_back(bare(n, lobe_axis::half_vector) > 1);
    return figures{{"mirror", bare(2, lobe_axis::mirror)},
                   {"half", bare(2, lobe_axis::half_vector)},
                   {"above", ranges(above)}};
  };
  into["A7"] = [] {
    double gap = 0;
    over_training_set([&](int n, int k, double q) {
      gap = std::max(gap, std::abs(angle_lobe<double>(n, k, q, angle_of_level<double>(n, q)) - q));
    });
    return figures{{"gap", gap}};
  };
  into["A8"] = [] {
    double at_limit = 0;
    double before = 1;
    over_training_set([&](int n, int k, double q) {
      const auto limit = angle_limit<double>(n, k, q);
      at_limit = std::max(at_limit, angle_lobe<double>(n, k, q, limit));
      before = std::min(before, angle_lobe<double>(n, k, q, 0.99 * limit));
    });
    return figures{{"at_limit", at_limit}, {"before", before}};
  };
}

}  // namespace

void measure_article(measurements& into) {
  measure_tables(into);
  measure_figures(into);
  measure_reflectance(into);
}

}  // namespace blysk::claims
