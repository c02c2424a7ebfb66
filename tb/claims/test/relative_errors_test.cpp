// SPDX-License-Identifier: Apache-2.0
// Relative errors in the highlight, from the formulas as the seeds print them.
#include <fmt/format.h>

#include <functional>

#include "tb/catch.h"
#include "tb/claims/test/literal.h"
#include "tb/claims/test/second.h"

namespace blysk::claims {
namespace {

using namespace literal;

/// Largest relative error by zone and n; entry 0 is unused.
using error_table = std::array<std::vector<double>, kZones.size()>;

error_table errors_of(const std::function<double(double n, zone z)>& error) {
  error_table result;
  for (const zone z : kZones) {
    auto& column = result[static_cast<std::size_t>(z)];
    column.assign(1001, 0);
    for (int n = first_of(z); n <= 1000; ++n) column[static_cast<std::size_t>(n)] = error(n, z);
  }
  return result;
}

error_table errors_of_lobe(double (*f)(double n, double c)) {
  return errors_of(
      [f](double n, zone z) { return relative_error([=](double c) { return f(n, c); }, n, edge_of(z, n)); });
}

error_table errors_of_parabola(double (*a_of)(double n)) {
  return errors_of([a_of](double n, zone z) {
    const double a = a_of(n);
    return relative_error([=](double c) { return parabola(a, c); }, n, edge_of(z, n));
  });
}

double at(const error_table& errors, zone z, int n) {
  return errors[static_cast<std::size_t>(z)][static_cast<std::size_t>(n)];
}

peak worst(const error_table& errors, zone z, int last = 1000) {
  return over_n(first_of(z), last, [&](int n) { return at(errors, z, n); });
}

void add_peak(figures& into, const std::string& key, const peak& p) {
  into[key] = 100 * p.value;
  into[key + "_n"] = static_cast<double>(p.n);
}

using named = std::vector<std::pair<std::string, const error_table*>>;

figures against(const named& candidates, double limit, int last = 1000) {
  figures result;
  for (const auto& [name, errors] : candidates) {
    for (const zone z : kZones) {
      const auto key = fmt::format("{}_{}", name, key_of(z));
      add_peak(result, key, worst(*errors, z, last));
      result[key + "_met"] =
          where(first_of(z), last, [&, &e = *errors](int n) { return at(e, z, n) <= limit; });
    }
  }
  return result;
}

const error_table& schlick_errors() {
  static const auto result = errors_of_lobe(schlick);
  return result;
}

/// The least of the largest error over a in [0, n], which falls with a and then rises.
double table_form_error(double n, double edge) {
  const auto error = [&](double a) {
    return largest([&](double c) { return std::abs(std::pow(c, a - n) / (n - n * c + c) - 1); }, edge, 1,
                   100);
  };
  constexpr double kGolden = 0.6180339887498949;
  double low = 0;
  double high = n;
  double left = high - kGolden * (high - low);
  double right = low + kGolden * (high - low);
  double at_left = error(left);
  double at_right = error(right);
  for (int i = 0; i < 48; ++i) {
    if (at_left < at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - kGolden * (high - low);
      at_left = error(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + kGolden * (high - low);
      at_right = error(right);
    }
  }
  return std::min(at_left, at_right);
}

}  // namespace

TEST_CASE("relative errors by a dense search", "[claims]") {
  const auto exact = errors_of_parabola(exact_a);
  const auto published = errors_of_parabola(published_a);
  const auto derived = errors_of_parabola(derived_a);
  const auto cq = errors_of_lobe(cosine_quadratic);
  const named quadratics{{"exact", &exact}, {"published", &published}, {"derived", &derived}};
  std::map<std::string, figures> rows;
  rows["T1"] = against({{"schlick", &schlick_errors()}}, 0.032);
  for (const zone z : kZones)
    add_peak(rows["T2"], fmt::format("schlick_{}", key_of(z)), worst(schlick_errors(), z));
  for (const int n : {1, 2, 10, 100, 1000}) {
    rows["T42"][fmt::format("n{}", n)] = 100 * at(schlick_errors(), zone::level_060, n);
    rows["T44"][fmt::format("n{}_060", n)] = 100 * at(cq, zone::level_060, n);
    // At c = n/(n + 1) the cosine-quadratic is (1 - 1/3)^2.
    rows["T44"][fmt::format("n{}_point", n)] = 100 * (4.0 / 9 * std::pow(1 + 1.0 / n, n) - 1);
  }
  // The limit itself, from an n at which it is reached to 1e-6.
  rows["T42"]["limit"] = 100 * (schlick(1e6, std::exp(std::log(0.6) / 1e6)) / 0.6 - 1);
  rows["T8"] = against(quadratics, 0.03);
  rows["T10"] = against(quadratics, 0.02);
  rows["T11"] = against(quadratics, 0.03, 512);
  rows["T9"] = {{"tail", 100 * relative_error([](double c) { return parabola(exact_a(100), c); }, 100,
                                              std::exp(std::log(0.1) / 100))},
                {"end", std::exp(100 * std::log1p(-1 / exact_a(100)))}};
  for (const zone z : kZones) {
    rows["T12"][fmt::format("ratio_{}", key_of(z))] =
        worst(schlick_errors(), z).value / worst(exact, z).value;
    rows["T12"][fmt::format("met_{}", key_of(z))] = where(first_of(z), 1000, [&](int n) {
      // Errors of mere rounding are none.
      return at(schlick_errors(), z, n) > 1e-12 && at(schlick_errors(), z, n) >= 10 * at(exact, z, n);
    });
  }
  rows["T17"] = against({{"cq", &cq}}, 0.03);
  for (const auto& [name, f] :
       {std::pair{"A", &reading_a}, {"B", &reading_b}, {"C", &reading_c}, {"D", &reading_d}}) {
    const auto errors = errors_of_lobe(f);
    add_peak(rows["E7"], name, worst(errors, zone::level_060));
    rows["E7"][fmt::format("{}_100", name)] = 100 * at(errors, zone::level_060, 100);
  }
  check_rows("relative errors by a dense search", rows);
}

TEST_CASE("the form of table 3.2 by a golden-section search", "[claims]") {
  const auto a = errors_of_lobe(reading_a);
  const auto b = errors_of_lobe(reading_b);
  const auto c = errors_of_lobe(reading_c);
  const auto d = errors_of_lobe(reading_d);
  const auto e = errors_of([](double n, zone z) { return table_form_error(n, edge_of(z, n)); });
  const named all{{"A", &a}, {"B", &b}, {"C", &c}, {"D", &d}, {"E", &e}};
  std::map<std::string, figures> rows;
  rows["T4"] = against(all, 0.032);
  rows["T5"] = against(all, 0.004);
  rows["T6"]["own"] = (100 - 32) / 10.0;
  for (const auto& [name, errors] : all) {
    for (const zone z : kZones)
      rows["T6"][fmt::format("{}_{}", name, key_of(z))] =
          100 * (worst(schlick_errors(), z).value - worst(*errors, z).value);
  }
  for (const zone z : kZones) add_peak(rows["T7"], fmt::format("E_{}", key_of(z)), worst(e, z));
  check_rows("the form of table 3.2 by a golden-section search", rows);
}

}  // namespace blysk::claims
