// SPDX-License-Identifier: Apache-2.0
// [T] 2.5: reflectance.
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <stdexcept>

#include "tb/claims/measure/over_exponents.h"
#include "tb/claims/words.h"

namespace blysk::claims {

using namespace golden;
namespace {

/// R of the cosine-quadratic at normal incidence as [T] (2.25) integrates: theta to `limit`, second lobe
/// included.
double published_integral(double n, double limit) {
  const auto integrand = [n](double theta) {
    const double w = (n + 1) / 3 * (std::cos(theta / 2) - 1) + 1;
    return w * w * std::cos(theta) * std::sin(theta);
  };
  return boost::math::constants::two_pi<double>() *
         boost::math::quadrature::gauss_kronrod<double, 61>::integrate(integrand, 0.0, limit, 10, 1e-12);
}

double published_limit(int n) {
  return 5.8 / std::sqrt(n);
}

/// Where the first lobe ends, or the hemisphere.
double true_limit(int n) {
  return std::min(boost::math::constants::half_pi<double>(),
                  2 * std::acos(std::max(-1.0, (n - 2.0) / (n + 1))));
}

double clipped_limit(int n) {
  return std::min(boost::math::constants::half_pi<double>(), published_limit(n));
}

std::vector<bool> above_one(const std::function<double(int)>& reflectance_of) {
  std::vector<bool> members;
  for (int n = 1; n <= kMaxExponent; ++n) members.push_back(reflectance_of(n) > 1);
  return members;
}

/// The last n with R > 1, of those from 1 on.
double last_above_one(double (*limit)(int)) {
  const auto members = above_one([=](int n) { return published_integral(n, limit(n)); });
  const auto last = std::ranges::count(members, true);
  if (!std::all_of(members.begin(), members.begin() + last, [](bool above) { return above; }))
    throw std::logic_error("R > 1 not for n from 1 on");
  return static_cast<double>(last);
}

figures published_energy() {
  const auto with_factor = [](double (*limit)(int)) {
    return [=](int n) { return (n + 6) / 24.55 * published_integral(n, limit(n)); };
  };
  figures result{{"above", ranges(above_one(with_factor(true_limit)))}};
  add_worst(result, "first", worst_over(1, kMaxExponent, with_factor(true_limit)));
  add_worst(result, "printed", worst_over(1, kMaxExponent, with_factor(published_limit)));
  add_worst(result, "oblique", worst_over(1, kMaxExponent, [&](int n) {
              return lobe_reflectance(lobe::cosine_quadratic_energy, n, lobe_axis::half_vector, 60);
            }));
  return result;
}

}  // namespace

void measure_energy(measurements& into) {
  into["T53"] = [] {
    const auto most = worst_over(1, kMaxExponent, [](int n) {
      return -lobe_reflectance(lobe::cosine_quadratic_energy, n, lobe_axis::half_vector, 0);
    });
    return figures{{"least", -most.value}, {"least_n", static_cast<double>(most.n)}};
  };
  into["T28"] = [] {
    const auto end = [](double n) { return std::sqrt(n) * 2 * std::acos((n - 2) / (n + 1)); };
    return figures{{"n14", end(14)}, {"n1000", end(1000)}, {"limit", 2 * std::sqrt(6)}};
  };
  into["T29"] = [] {
    return figures{{"printed", last_above_one(published_limit)},
                   {"clipped", last_above_one(clipped_limit)},
                   {"first", last_above_one(true_limit)}};
  };
  into["T30"] = published_energy;
  into["T45"] = [] {
    figures result;
    add_worst(result, "gain", worst_over(1, kMaxExponent, [](int n) {
                double oblique = 0;
                for (const double degrees : {15.0, 30.0, 45.0, 60.0, 80.0})
                  oblique = std::max(
                      oblique, lobe_reflectance(lobe::cosine_quadratic, n, lobe_axis::half_vector, degrees));
                return oblique / lobe_reflectance(lobe::cosine_quadratic, n, lobe_axis::half_vector, 0);
              }));
    return result;
  };
  into["T31"] = [] {
    const auto blinn = [](int n) {
      return lobe_reflectance(lobe::blinn_normalised, n, lobe_axis::half_vector, 0);
    };
    figures result{{"n1", blinn(1)}};
    add_worst(result, "largest", worst_over(1, kMaxExponent, blinn));
    return result;
  };
  into["T32"] = [] { return figures{{"printed", std::cos(0.0) / 2}, {"meant", std::cos(0.0 / 2)}}; };
}

}  // namespace blysk::claims
