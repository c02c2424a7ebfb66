// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/article.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "tb/claims/judge.h"
#include "tb/claims/words.h"
#include "tb/golden/angle.h"

namespace blysk::claims {

using namespace golden;
namespace {

cells worst_cells(const auto& metric) {
  cells result{};
  for (std::size_t row = 0; row < kLevels.size(); ++row) {
    for (int k = 1; k <= kPowers; ++k)
      result[row][static_cast<std::size_t>(k) - 1] =
          worst_over(k + 1, kMaxExponent, [&](int n) { return metric(n, k, kLevels[row]); }).value;
  }
  return result;
}

by_level_and_power<demand> printed_cells_of(const std::string& prefix) {
  by_level_and_power<demand> result;
  for (std::size_t row = 0; row < kLevels.size(); ++row)
    std::ranges::copy(claim_of(fmt::format("{}{}", prefix, kLevels[row])).stated, result[row].begin());
  return result;
}

}  // namespace

double angle_error(double n, double k, double q, epicentre where) {
  constexpr int kSamples = 48;
  const double scale = angle_scale(n, k, q);
  const double edge = angle_of_cosine(epicentre_edge(where, n));
  const auto error = [&](double x) {
    return std::abs(angle_lobe_scaled(k, scale * x) / std::pow(std::cos(x), n) - 1);
  };
  int top = 0;
  double result = 0;
  for (int i = 1; i <= kSamples; ++i) {
    const double value = error(edge * i / kSamples);
    if (value > result) {
      result = value;
      top = i;
    }
  }
  if (top == kSamples) return result;
  constexpr int kBits = 16;  // of x: the error is flat there
  const auto refined = boost::math::tools::brent_find_minima([&](double x) { return -error(x); },
                                                             edge * std::max(0, top - 1) / kSamples,
                                                             edge * (top + 1) / kSamples, kBits);
  return std::max(result, -refined.second);
}

const cells& table1(epicentre where) {
  static const auto all = [] {
    std::array<cells, kEpicentres.size()> result{};
    for (const epicentre e : kEpicentres)
      result[static_cast<std::size_t>(e)] =
          worst_cells([e](int n, int k, double q) { return 100 * angle_error(n, k, q, e); });
    return result;
  }();
  return all[static_cast<std::size_t>(where)];
}

const cells& table2() {
  static const cells result = worst_cells([](int n, int k, double q) {
    return 1000 *
           std::abs(angle_coefficient_fitted<double>(n, k, q) / angle_coefficient_exact<double>(n, k, q) - 1);
  });
  return result;
}

const by_level_and_power<demand>& printed_cells(int number) {
  static const auto first = printed_cells_of("A-T1-");
  static const auto second = printed_cells_of("A-T2-");
  return number == 1 ? first : second;
}

reproduction reproduce(const cells& measured, const by_level_and_power<demand>& printed) {
  reproduction result;
  for (std::size_t row = 0; row < measured.size(); ++row) {
    for (std::size_t k = 0; k < kPowers; ++k) {
      const std::string figure = number(measured[row][k], 4);  // as the rows print it
      const double miss = miss_of(printed[row][k], figure);
      result.met += met(printed[row][k], figure);
      result.within_a_unit += miss <= 1;
      result.largest_miss = std::max(result.largest_miss, miss);
    }
  }
  return result;
}

}  // namespace blysk::claims
