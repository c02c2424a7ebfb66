// SPDX-License-Identifier: Apache-2.0
// [A] by its literal formulas, its integral by sums of cosines.
#include <fmt/format.h>

#include <numeric>

#include "tb/catch.h"
#include "tb/claims/judge.h"
#include "tb/claims/test/direct_sum.h"
#include "tb/claims/test/literal.h"
#include "tb/claims/test/second.h"
#include "tb/golden/registry.h"

namespace blysk::claims {
namespace {

using namespace literal;

constexpr std::array kTraining{1, 2, 3, 4, 5, 7, 10, 20, 50, 100, 200, 500, 1000};

double scale_of(double n, double k, double q) {
  return std::acos(std::pow(q, 1 / k)) / std::acos(std::pow(q, 1 / n));
}

double limit_of(double n, double k, double q) {
  return kPi / 2 / scale_of(n, k, q);
}

/// Integral of cos^k(A x) cos x sin x from 0 to `end`, with cos^k y = 2^-k sum over j of (k over j) cos((k - 2 j) y),
/// term by term: integral of cos(a x) sin(2 x) = -cos((2 - a) x) / (2 (2 - a)) - cos((2 + a) x) / (2 (2 + a)).
double integral(int n, int k, double q, double end) {
  const double scale = scale_of(n, k, q);
  double binomial = std::pow(0.5, k);
  double result = 0;
  for (int j = 0; j <= k; ++j) {
    const double a = (k - 2 * j) * scale;
    for (const double b : {2 - a, 2 + a}) {
      // (1 - cos(b x)) / (2 b) as sin^2(b x / 2) / b; its limit at b = 0 is 0
      if (b != 0) result += binomial * std::pow(std::sin(b * end / 2), 2) / b;
    }
    binomial *= static_cast<double>(k - j) / (j + 1);
  }
  return result / 2;
}

double exact_coefficient(int n, int k, double q) {
  return 1 / (2 * kPi * integral(n, k, q, limit_of(n, k, q)));
}

double printed_fit(int n, int k, double q) {
  if (q < 0.45) return 0.608 * n * (q - 0.193) / (2 * q + 2 * k) + 0.161 * n + 0.284;
  return 0.743 * q * (-0.0133 * k * n + 0.167 * n) / k + 0.167 * n + 0.245;
}

/// With the digits of figs. 7 and 8.
double figure_fit(int n, int k, double q) {
  if (q < 0.45) return 0.608 * n * (q - 0.193) / (2 * q + 2 * k) + 0.161445672 * n + 0.283821491376;
  return 0.743044 * q * (-0.013319008848 * k * n + 0.167 * n) / k + 0.167 * n + 0.245;
}

/// R at normal incidence with x from the half vector: 8 pi integral of cos^k(A x) cos x sin x (2 cos^2 x - 1), as far as
/// the outgoing ray is above the surface, by Simpson's rule.
double half_vector_reflectance(int n, int k, double q) {
  const double scale = scale_of(n, k, q);
  const double end = std::min(limit_of(n, k, q), kPi / 4);
  constexpr int kSteps = 400;
  double result = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = end * i / kSteps;
    const double value = std::pow(std::max(0.0, std::cos(scale * x)), k) * std::cos(x) * std::sin(x) *
                         (2 * std::cos(x) * std::cos(x) - 1);
    result += value * (i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2) * end / kSteps / 3;
  }
  return 8 * kPi * result;
}

struct fit_quality {
  double determination;
  double mean_error;
};

/// For Q = first/10..last/10: R2 as 1 - residual/(sum of squares - n mean^2).
fit_quality quality(int first, int last, double (*fit)(int n, int k, double q)) {
  double sum = 0;
  double squares = 0;
  double residual = 0;
  double error = 0;
  int count = 0;
  for (int i = first; i <= last; ++i) {
    for (int k = 1; k <= 5; ++k) {
      for (const int n : kTraining) {
        const double exact = exact_coefficient(n, k, i / 10.0);
        const double off = exact - fit(n, k, i / 10.0);
        sum += exact;
        squares += exact * exact;
        residual += off * off;
        error += std::abs(off);
        ++count;
      }
    }
  }
  return {1 - residual / (squares - sum * sum / count), error / count};
}

/// Largest relative error, %, of the angle-based lobe.
double lobe_error(int n, int k, double q, zone z) {
  const double scale = scale_of(n, k, q);
  const double end = std::acos(edge_of(z, n));
  return 100 * largest(
                   [=](double x) {
                     const double y = std::min(kPi / 2, scale * x);
                     return std::abs(std::pow(std::cos(y), k) / std::pow(std::cos(x), n) - 1);
                   },
                   0, end, 200);
}

struct counted {
  int met = 0;
  int within = 0;
  double miss = 0;
};

/// Cells of table 1 or 2 against what the rows print.
using cells = std::array<std::array<double, 5>, 9>;

counted count(const cells& measured, const std::string& prefix) {
  counted result;
  for (std::size_t row = 0; row < measured.size(); ++row) {
    const claim& c = claim_of(fmt::format("{}0.{}", prefix, row + 1));
    for (std::size_t k = 0; k < 5; ++k) {
      const std::string& printed = c.stated[k].value;
      const bool decimal = printed.find('.') != std::string::npos;
      const double miss = std::abs(measured[row][k] - std::stod(printed)) * (decimal ? 10 : 1);
      result.met += miss <= 0.5;
      result.within += miss <= 1;
      result.miss = std::max(result.miss, miss);
    }
  }
  return result;
}

cells measure(const std::function<double(int n, int k, double q)>& error) {
  cells result{};
  for (int row = 1; row <= 9; ++row) {
    for (int k = 1; k <= 5; ++k)
      result[static_cast<std::size_t>(row) - 1][static_cast<std::size_t>(k) - 1] =
          over_n(k + 1, 1000, [&](int n) { return error(n, k, row / 10.0); }).value;
  }
  return result;
}

void add_cells(std::map<std::string, figures>& rows, const std::string& prefix, const cells& measured) {
  for (std::size_t row = 0; row < measured.size(); ++row) {
    for (std::size_t k = 0; k < 5; ++k)
      rows[fmt::format("{}0.{}", prefix, row + 1)][fmt::format("k{}", k + 1)] = measured[row][k];
  }
}

}  // namespace

TEST_CASE("table 1 of the article by the literal formula", "[claims]") {
  std::map<std::string, figures> rows;
  cells inflection{};
  for (const auto& [key, z] :
       {std::pair{"c060", zone::level_060}, {"c056", zone::level_056}, {"infl", zone::inflection}}) {
    const cells measured = measure([zone = z](int n, int k, double q) { return lobe_error(n, k, q, zone); });
    const counted found = count(measured, "A-T1-");
    rows["A-T1"][key] = static_cast<double>(found.met);
    rows["A-T1"][fmt::format("{}_miss", key)] = found.miss;
    if (z == zone::inflection) inflection = measured;
  }
  add_cells(rows, "A-T1-", inflection);
  rows["A1"] = {{"angle", inflection[4][4]}, {"schlick", 100 * over_n(2, 1000, [](int n) {
                                                                 return relative_error(
                                                                     [n](double c) { return schlick(n, c); },
                                                                     n, edge_of(zone::inflection, n), 50);
                                                               }).value}};
  for (std::size_t k = 0; k < 5; ++k) {
    const auto least = std::min_element(inflection.begin(), inflection.end(),
                                        [k](const auto& a, const auto& b) { return a[k] < b[k]; });
    rows["A4"][fmt::format("k{}", k + 1)] = static_cast<double>(least - inflection.begin() + 1) / 10;
  }
  check_rows("table 1 of the article by the literal formula", rows);
}

TEST_CASE("the article's coefficient by sums of cosines", "[claims]") {
  std::map<std::string, figures> rows;
  const cells deviations = measure([](int n, int k, double q) {
    return 1000 * std::abs(printed_fit(n, k, q) / exact_coefficient(n, k, q) - 1);
  });
  add_cells(rows, "A-T2-", deviations);
  const counted found = count(deviations, "A-T2-");
  rows["A-T2"] = {{"met", static_cast<double>(found.met)},
                  {"within", static_cast<double>(found.within)},
                  {"miss", found.miss}};
  double largest_of_all = 0;
  for (const auto& row : deviations)
    largest_of_all = std::max(largest_of_all, *std::max_element(row.begin(), row.end()));
  rows["A2"]["largest"] = largest_of_all;
  rows["A3"]["largest"] = *std::max_element(deviations[5].begin(), deviations[5].end());

  for (const int n : kTraining) rows["A-F4-0.5"][fmt::format("n{}", n)] = exact_coefficient(n, 1, 0.5);
  rows["E18"]["coef"] = exact_coefficient(2, 1, 0.5);
  for (const int n : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000})
    rows["A-F4-0.1"][fmt::format("n{}", n)] = exact_coefficient(n, 1, 0.1);
  for (const auto& [id, first, last] : {std::tuple{"A-F7", 1, 4}, {"A-F8", 5, 9}})
    rows[id] = {{"formula", quality(first, last, printed_fit).determination},
                {"figure", quality(first, last, figure_fit).determination}};
  rows["A-F6"] = {{"low", quality(1, 4, figure_fit).mean_error},
                  {"high", quality(5, 9, figure_fit).mean_error}};

  double mirror = 0;
  double half = 0;
  double oblique = 0;
  double gap = 0;
  double before = 1;
  for (int i = 1; i <= 9; ++i) {
    const double q = i / 10.0;
    for (int k = 1; k <= 5; ++k) {
      for (const int n : kTraining) {
        const double scale = scale_of(n, k, q);
        // acos near 1 leaves n roundoffs of cos^n; in the whole table n k 64 of them would still print as 0.
        gap = std::max(
            gap, std::abs(std::pow(std::cos(scale * std::acos(std::pow(q, 1.0 / n))), k) - q) / (n * k));
        before = std::min(before, std::pow(std::cos(0.99 * scale * limit_of(n, k, q)), k));
        if (n <= k) continue;
        const double fitted = printed_fit(n, k, q);
        // From the mirror direction the hemisphere holds all of the lobe, so R is fitted over exact.
        mirror = std::max(mirror, fitted / exact_coefficient(n, k, q));
        half = std::max(half, fitted * half_vector_reflectance(n, k, q));
        oblique = std::max(
            oblique,
            fitted * direct_sum(
                         [&](double c) { return std::pow(std::max(0.0, std::cos(scale * std::acos(c))), k); },
                         limit_of(n, k, q), 60, 160));
      }
    }
  }
  rows["A5"] = {{"mirror", mirror}, {"half", half}, {"oblique", oblique}};
  // n = k = 2: cos^2 itself, 2 pi times the integral of cos^3 sin.
  rows["A6"] = {
      {"mirror", 2 * kPi / 4},
      {"half", half_vector_reflectance(2, 2, 0.5)},
      {"above", where(1, 1000, [](int n) { return half_vector_reflectance(n, 2, 0.5) > 1; }).substr(5)}};
  rows["A7"]["gap"] = gap;
  rows["A8"] = {{"at_limit", std::abs(std::cos(scale_of(10, 1, 0.5) * limit_of(10, 1, 0.5)))},
                {"before", before}};

  rows["E9"] = {
      {"mirror", exact_coefficient(100, 2, 0.5) * 2 * kPi * integral(100, 2, 0.5, limit_of(100, 2, 0.5))},
      {"half", exact_coefficient(100, 2, 0.5) * half_vector_reflectance(100, 2, 0.5)}};
  const std::array in_the_gap{10.0, 2.0, 0.45};
  const std::array equal{2.0, 2.0, 0.5};
  CHECK_THROWS_AS(golden::find_model("angle-coef-fitted")->value(in_the_gap), std::domain_error);
  CHECK_THROWS_AS(golden::find_model("angle-coef-fitted")->value(equal), std::domain_error);
  rows["E10"] = {{"gap", "refused"}, {"equal", "refused"}, {"exact", exact_coefficient(10, 2, 0.45)}};
  rows["E11"] = {{"n1", limit_of(1, 5, 0.5)},
                 {"n4", limit_of(4, 5, 0.5)},
                 {"n5", kPi / 2},
                 {"clipped", integral(1, 5, 0.5, kPi / 2) / integral(1, 5, 0.5, limit_of(1, 5, 0.5))}};
  check_rows("the article's coefficient by sums of cosines", rows);
}

}  // namespace blysk::claims
