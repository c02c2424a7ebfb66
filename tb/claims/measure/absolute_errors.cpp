// SPDX-License-Identifier: Apache-2.0
// [T]: absolute errors, and points of the curves.
#include <fmt/format.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "tb/claims/measure/over_exponents.h"
#include "tb/claims/speed.h"

namespace blysk::claims {

using namespace golden;
namespace {

const error_summary& at_exponent(lobe which, int n) {
  return errors_of(which)[static_cast<std::size_t>(n) - 1];
}

/// rms over largest absolute error; n from 3 on, as the exact quadratic has no error at n = 1 and 2.
figures evenness(lobe which) {
  const auto share = [&](int n) { return at_exponent(which, n).rms / at_exponent(which, n).whole.value; };
  const worst least = worst_over(3, kMaxExponent, [&](int n) { return -share(n); });
  figures result{{"n10", share(10)}, {"n100", share(100)}};
  add_worst(result, "least", {-least.value, least.n});
  return result;
}

/// Largest absolute errors of Schlick's lobe over those of the cosine-quadratic, and the n at which each is so many times
/// the other.
figures times_less(double factor) {
  figures result;
  const auto compare = [&](std::string_view key, int first, const auto& error) {
    const auto largest = [&](lobe which) {
      return worst_over(first, kMaxExponent, [&](int n) { return error(which, n); }).value;
    };
    result[fmt::format("ratio_{}", key)] = largest(lobe::schlick) / largest(lobe::cosine_quadratic);
    result[fmt::format("met_{}", key)] = exponents_where(first, kMaxExponent, [&](int n) {
      const double schlick = error(lobe::schlick, n);
      return schlick > kRounding && schlick >= factor * error(lobe::cosine_quadratic, n);
    });
  };
  for (const epicentre where : kEpicentres) {
    compare(key_of(where), first_exponent(where), [&](lobe which, int n) {
      return at_exponent(which, n).absolute[static_cast<std::size_t>(where)].value;
    });
  }
  compare("whole", 1, [](lobe which, int n) { return at_exponent(which, n).whole.value; });
  return result;
}

figures curve_area() {
  const auto area = worst_over(2, kMaxExponent, [](int n) {
    const auto lobe_area = [n](double c) { return cosine_quadratic(1.0 * n, c); };
    const double integral =
        boost::math::quadrature::gauss_kronrod<double, 31>::integrate(lobe_area, 1 - 3.0 / (n + 1), 1.0);
    return std::abs(integral * (n + 1) - 1) / n;  // the root's rounding is n times that of the lobe's width
  });
  const double first = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
      [](double c) { return cosine_quadratic(1.0, c); }, 0.0, 1.0);
  return {{"gap", area.value}, {"n1", first}};
}

/// The point where the relative error is stationary, c = n / (n + 1), and its level.
figures stationary_point() {
  const auto place = worst_over(1, kMaxExponent, [](int n) {
    return std::abs(std::cos(std::atan(std::sqrt(1 + 2.0 * n) / n)) - n / (n + 1.0));
  });
  const auto level = [](int n) { return std::pow(n / (n + 1.0), n); };
  const auto error = [&](int n) {
    return in_percent(cosine_quadratic<double>(n, n / (n + 1.0)) / level(n) - 1);
  };
  int from = 1;
  while (level(from) > 0.4) ++from;
  return {{"place", place.value}, {"level_1", level(1)},       {"level_1000", level(1000)},
          {"error_2", error(2)},  {"error_1000", error(1000)}, {"from", static_cast<double>(from)}};
}

figures foot_of_the_lobe() {
  const auto place = worst_over(3, kMaxExponent, [](int n) {
    return std::abs(std::cos(std::atan(std::sqrt(6.0 * n - 3) / (n - 2))) - (n - 2.0) / (n + 1));
  });
  figures result{{"place", place.value},
                 {"level_100", std::pow(at_exponent(lobe::cosine_quadratic, 100).whole.cos, 100)}};
  add_worst(result, "foot",
            worst_over(3, kMaxExponent, [](int n) { return std::pow((n - 2.0) / (n + 1), n); }));
  add_worst(result, "whole", worst_whole(lobe::cosine_quadratic));
  return result;
}

double faster(std::string_view how, std::string_view other) {
  return recorded_speed(fmt::format("{}/cosine-quadratic", how)) /
         recorded_speed(fmt::format("{}/{}", how, other));
}

}  // namespace

void measure_absolute_errors(measurements& into) {
  into["T3"] = [] {
    const auto rises = worst_over(1, kMaxExponent, [](int n) {
      double result = -1;
      for (int i = 0; i < 256; ++i)
        result = std::max(result, schlick<double>(n, i / 256.0) - schlick<double>(n, (i + 1) / 256.0));
      return result;
    });
    return figures{{"step", rises.value}};
  };
  into["T13"] = [] { return evenness(lobe::quadratic_exact); };
  into["T43"] = [] { return evenness(lobe::cosine_quadratic); };
  into["T14"] = curve_area;
  into["T15"] = stationary_point;
  into["T16"] = foot_of_the_lobe;
  into["T52"] = [] {
    const auto bright = [](double degrees) {
      return evaluate(lobe::blinn, 10.0, std::cos(degrees * boost::math::constants::degree<double>()));
    };
    return figures{{"a0", bright(0)},
                   {"a15", bright(15)},
                   {"a30", bright(30)},
                   {"a45", bright(45)},
                   {"ratio", bright(30) / bright(15)}};
  };
  into["T18"] = [] { return times_less(4); };
  into["T19"] = [] { return times_less(3); };
  into["T20"] = [] {
    return figures{{"scalar", faster("scalar", "schlick")},
                   {"twice", faster("double", "schlick")},
                   {"single", faster("float", "schlick")}};
  };
  into["T21"] = [] {
    return figures{{"sphere", faster("sphere", "blinn")},
                   {"scalar", faster("scalar", "blinn")},
                   {"vector", faster("double", "blinn")}};
  };
}

}  // namespace blysk::claims
