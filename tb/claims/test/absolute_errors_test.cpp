// SPDX-License-Identifier: Apache-2.0
// Absolute errors over the whole range, from the formulas as the seeds print them.
#include <fmt/format.h>

#include "tb/catch.h"
#include "tb/claims/test/fifty_digits.h"
#include "tb/claims/test/literal.h"
#include "tb/claims/test/second.h"

namespace blysk::claims {
namespace {

using namespace literal;

/// Largest |f - c^n| over [0, 1], f smooth on either side of its kink: searched over n (1 - c) up to 40, beyond which
/// c^n is below 1e-17 and the lobes here have ended or fall on.
template <class F>
double whole_error(const F& f, double n, double kink) {
  const auto error = [&](double c) { return std::abs(f(c) - std::pow(c, n)); };
  const double low = std::max(0.0, 1 - 40 / n);
  double result = error(kink);
  if (kink > low) result = std::max(result, largest(error, low, kink, 1000));
  return std::max(result, largest(error, std::max(low, kink), 1, 1000));
}

double schlick_whole(int n) {
  return whole_error([n](double c) { return schlick(n, c); }, n, 0);
}

double cosine_quadratic_whole(int n) {
  return whole_error([n](double c) { return cosine_quadratic(n, c); }, n, std::max(0.0, (n - 2.0) / (n + 1)));
}

double parabola_whole(double a, int n) {
  return whole_error([a](double c) { return parabola(a, c); }, n, parabola_root(a));
}

std::vector<double> by_n(const std::function<double(int)>& f) {
  std::vector<double> result{0};
  for (int n = 1; n <= 1000; ++n) result.push_back(f(n));
  return result;
}

peak worst(const std::vector<double>& values, int first = 1) {
  return over_n(first, 1000, [&](int n) { return values[static_cast<std::size_t>(n)]; });
}

void add_peak(figures& into, const std::string& key, const peak& p, double factor = 1) {
  into[key] = factor * p.value;
  into[key + "_n"] = static_cast<double>(p.n);
}

long double power_integral(long double low, int power) {
  return (1 - std::pow(low, static_cast<long double>(power + 1))) / (power + 1);
}

/// Root mean square of the exact quadratic's error: its square is a polynomial, and c^n vanishes in none of it.
double parabola_rms(int n) {
  const long double a = exact_a(n);
  const long double b = 1 - a;
  const long double r = parabola_root(exact_a(n));
  const long double square =
      a * a * power_integral(r, 4) + 2 * a * b * power_integral(r, 3) + b * b * power_integral(r, 2);
  const long double mixed = a * power_integral(r, n + 2) + b * power_integral(r, n + 1);
  return static_cast<double>(std::sqrt(square - 2 * mixed + 1 / (2.0L * n + 1)));
}

/// The same of the cosine-quadratic (s (c - 1) + 1)^2, n >= 2: the integral of its square is 1/(5 s).
double cosine_quadratic_rms(int n) {
  const long double s = (n + 1) / 3.0L;
  const long double r = 1 - 1 / s;
  const long double mixed = s * s * power_integral(r, n + 2) + 2 * s * (1 - s) * power_integral(r, n + 1) +
                            (1 - s) * (1 - s) * power_integral(r, n);
  return static_cast<double>(std::sqrt(1 / (5 * s) - 2 * mixed + 1 / (2.0L * n + 1)));
}

figures evenness(double (*rms)(int n), const std::vector<double>& whole) {
  const auto share = [&](int n) { return rms(n) / whole[static_cast<std::size_t>(n)]; };
  const peak least = over_n(3, 1000, [&](int n) { return -share(n); });
  figures result{{"n10", share(10)}, {"n100", share(100)}};
  add_peak(result, "least", {-least.value, least.n});
  return result;
}

/// cos^n where the cosine-quadratic of n = 100 errs most: its error's derivative, 2 s (s (c - 1) + 1) - n c^(n - 1), goes
/// through 0 there, between the inflection of c^n and the axis.
double level_of_largest_error() {
  constexpr int kExponent = 100;
  const double s = (kExponent + 1) / 3.0;
  const auto derivative = [=](double c) {
    return 2 * s * (s * (c - 1) + 1) - kExponent * std::pow(c, kExponent - 1);
  };
  double low = 0.99;
  double high = 0.9999;
  REQUIRE(derivative(low) * derivative(high) < 0);
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (derivative(low) * derivative(middle) <= 0 ? high : low) = middle;
  }
  return std::pow(low, kExponent);
}

}  // namespace

TEST_CASE("absolute errors by a dense search", "[claims]") {
  const auto schlick_by_n = by_n(schlick_whole);
  const auto cq_by_n = by_n(cosine_quadratic_whole);
  const auto exact = by_n([](int n) { return parabola_whole(exact_a(n), n); });
  const auto published = by_n([](int n) { return parabola_whole(published_a(n), n); });
  const auto derived = by_n([](int n) { return parabola_whole(derived_a(n), n); });
  std::map<std::string, figures> rows;

  for (const auto& [key, whole, a_of] : {std::tuple{"published", &published, &published_a},
                                         {"derived", &derived, &derived_a},
                                         {"exact", &exact, &exact_a}}) {
    add_peak(rows["P5"], key, worst(*whole));
    add_peak(rows["P5"], fmt::format("{}_056", key),
             over_n(1, 1000,
                    [a = a_of](int n) {
                      return relative_error([=](double c) { return parabola(a(n), c); }, n,
                                            edge_of(zone::level_056, n), 100);
                    }),
             100);
    for (const int n : {1, 2, 10, 100, 1000})
      rows["E1"][fmt::format("{}_{}", key, n)] = (*whole)[static_cast<std::size_t>(n)];
  }
  rows["E1"]["offset"] = exact_a(1000) - 1000 * (derived_a(2) - derived_a(1));

  rows["T13"] = evenness(parabola_rms, exact);
  rows["T43"] = evenness(cosine_quadratic_rms, cq_by_n);

  const double place = largest_gap(3, [](int n) {
    return real(cos(atan(real(sqrt(real(6 * n - 3)) / (n - 2)))) - real(n - 2) / (n + 1));
  });
  rows["T16"] = {{"place", place}, {"level_100", level_of_largest_error()}};
  add_peak(rows["T16"], "foot",
           over_n(3, 1000, [](int n) { return std::exp(n * std::log1p(-3.0 / (n + 1))); }));
  add_peak(rows["T16"], "whole", worst(cq_by_n));

  for (const auto& [id, factor] : {std::pair{"T18", 4}, {"T19", 3}}) {
    const auto compare = [&, &row = rows[id], times = factor](std::string_view key, int first,
                                                              const std::vector<double>& reference,
                                                              const std::vector<double>& tried) {
      row[fmt::format("ratio_{}", key)] = worst(reference, first).value / worst(tried, first).value;
      row[fmt::format("met_{}", key)] = where(first, 1000, [&](int n) {
        const auto i = static_cast<std::size_t>(n);
        return reference[i] > 1e-12 && reference[i] >= times * tried[i];  // errors of mere rounding are none
      });
    };
    for (const zone z : kZones) {
      const auto inside = [z](double (*f)(double n, double c)) {
        return by_n([=](int n) {
          if (n < first_of(z)) return 0.0;
          return largest([=](double c) { return std::abs(f(n, c) - std::pow(c, n)); }, edge_of(z, n), 1, 100);
        });
      };
      compare(key_of(z), first_of(z), inside(schlick), inside(cosine_quadratic));
    }
    compare("whole", 1, schlick_by_n, cq_by_n);
  }
  check_rows("absolute errors by a dense search", rows);
}

}  // namespace blysk::claims
