// SPDX-License-Identifier: Apache-2.0
// Reflectance: at normal incidence by the integrals of polynomials, elsewhere by sums over half vectors.
#include <fmt/format.h>

#include <functional>

#include "tb/catch.h"
#include "tb/claims/test/direct_sum.h"
#include "tb/claims/test/literal.h"
#include "tb/claims/test/second.h"

namespace blysk::claims {
namespace {

using namespace literal;

const double kHorizon = std::sqrt(0.5);  ///< cosine of the half angle at which the outgoing ray is level

/// 8 pi times the integral of f(c) c (2 c^2 - 1) for c from `low` to 1, f = f0 + f1 u + f2 u^2 with u = 1 - c: R at
/// normal incidence, term by term.
double polynomial_reflectance(const std::array<double, 3>& f, double low) {
  const std::array<double, 4> weight{1, -5, 6, -2};  // (1 - u)(2 (1 - u)^2 - 1)
  const double end = 1 - low;
  double result = 0;
  for (std::size_t i = 0; i < weight.size(); ++i) {
    for (std::size_t j = 0; j < f.size(); ++j) {
      const auto power = static_cast<double>(i + j + 1);
      result += weight[i] * f[j] * std::pow(end, power) / power;
    }
  }
  return 8 * kPi * result;
}

/// Of the cosine-quadratic down to the cosine `low`.
double cq_reflectance(double n, double low) {
  const double s = (n + 1) / 3;
  return polynomial_reflectance({1, -2 * s, s * s}, low);
}

double cq_root(double n) {
  return std::max(0.0, (n - 2) / (n + 1));
}

double first_lobe(int n) {
  return cq_reflectance(n, std::max(kHorizon, cq_root(n)));
}

/// theta up to 5.8/sqrt(n), so half of that for the half angle.
double to_printed_limit(int n) {
  return cq_reflectance(n, std::cos(2.9 / std::sqrt(n)));
}

double to_clipped_limit(int n) {
  return cq_reflectance(n, std::max(kHorizon, std::cos(2.9 / std::sqrt(n))));
}

/// Of a (c^2 - c) + c = c (1 - a u) on the derived line, c = 1 - u.
double parabola_reflectance(double n) {
  const double a = derived_a(n);
  return polynomial_reflectance({1, -1 - a, a}, std::max(kHorizon, parabola_root(a)));
}

/// 3 a^2 / (4 pi (3 a - 1)), or for a < 1 3 / (4 pi (3 - a)).
double safe_factor(double n) {
  const double a = derived_a(n);
  return a < 1 ? 3 / (4 * kPi * (3 - a)) : 3 * a * a / (4 * kPi * (3 * a - 1));
}

/// Of c^n: 8 pi times the integral from sqrt(1/2) to 1 of c^(n + 1) (2 c^2 - 1).
double power_reflectance(double n) {
  return 8 * kPi * (2 * (1 - std::pow(0.5, n / 2 + 2)) / (n + 4) - (1 - std::pow(0.5, n / 2 + 1)) / (n + 2));
}

/// Fine where the horizon cuts a wide lobe, coarse where a narrow one is smooth.
int steps_for(int n) {
  return n <= 12 ? 600 : n <= 60 ? 120 : 40;
}

double cq_oblique(int n, double degrees) {
  return direct_sum([n](double c) { return cosine_quadratic(n, c); }, std::acos(cq_root(n)), degrees,
                    steps_for(n));
}

double parabola_oblique(int n, double degrees) {
  const double a = derived_a(n);
  return direct_sum([a](double c) { return parabola(a, c); }, std::acos(parabola_root(a)), degrees,
                    steps_for(n));
}

/// Last n with R > 1, of those from 1 on.
double last_above_one(double (*r)(int)) {
  const std::string above = where(1, 1000, [r](int n) { return r(n) > 1; });
  REQUIRE(above.starts_with("n in 1.."));
  return std::stod(above.substr(above.rfind('.') + 1));
}

void add_peak(figures& into, const std::string& key, const peak& p) {
  into[key] = p.value;
  into[key + "_n"] = static_cast<double>(p.n);
}

}  // namespace

TEST_CASE("reflectance by polynomials and direct sums", "[claims]") {
  std::map<std::string, figures> rows;
  // The root by the half angle's formula: 1 - (n + 1)/3 2 sin^2(theta/4) = 0.
  const auto end = [](double n) { return std::sqrt(n) * 4 * std::asin(std::sqrt(1.5 / (n + 1))); };
  rows["T28"] = {{"n14", end(14)}, {"n1000", end(1000)}, {"limit", end(1e10)}};
  rows["T29"] = {{"printed", last_above_one(to_printed_limit)},
                 {"clipped", last_above_one(to_clipped_limit)},
                 {"first", last_above_one(first_lobe)}};

  const auto published = [](int n) { return (n + 6) / 24.55; };
  const auto energy = [&](int n) { return published(n) * first_lobe(n); };
  const peak least = over_n(1, 1000, [&](int n) { return -energy(n); });
  rows["T53"] = {{"least", -least.value}, {"least_n", static_cast<double>(least.n)}};
  add_peak(rows["T30"], "first", over_n(1, 1000, energy));
  add_peak(rows["T30"], "printed",
           over_n(1, 1000, [&](int n) { return published(n) * to_printed_limit(n); }));
  add_peak(rows["T30"], "oblique", over_n(1, 1000, [&](int n) { return published(n) * cq_oblique(n, 60); }));
  rows["T30"]["above"] =
      where(1, 1000, [&](int n) { return energy(n) > 1; }).substr(std::string("n in ").size());

  add_peak(rows["T45"], "gain", over_n(1, 1000, [](int n) {
             double oblique = 0;
             for (const double degrees : {15, 30, 45, 60, 80})
               oblique = std::max(oblique, cq_oblique(n, degrees));
             return oblique / first_lobe(n);
           }));

  const auto blinn_energy = [](int n) { return (n + 6) / (8 * kPi) * power_reflectance(n); };
  rows["T31"] = {{"n1", blinn_energy(1)}};
  add_peak(rows["T31"], "largest", over_n(1, 1000, blinn_energy));

  figures largest{{"published", 0.0}, {"safe", 0.0}, {"quadratic", 0.0}};
  for (int n = 1; n <= 1000; ++n) {
    double cq = first_lobe(n);
    double quadratic = parabola_reflectance(n);
    for (const double degrees : {30, 60, 80}) {
      cq = std::max(cq, cq_oblique(n, degrees));
      quadratic = std::max(quadratic, parabola_oblique(n, degrees));
    }
    const auto raise = [&](const char* key, double value) {
      largest[key] = std::max(std::get<double>(largest[key]), value);
    };
    raise("published", published(n) * cq);
    raise("safe", (n + 1) / (8 * kPi) * cq);
    raise("quadratic", safe_factor(n) * quadratic);
  }
  rows["E8"] = largest;
  check_rows("reflectance by polynomials and direct sums", rows);
}

}  // namespace blysk::claims
