// SPDX-License-Identifier: Apache-2.0
// Where a seed contradicts itself or mathematics: what the printed form measures.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "tb/claims/measure/listing_triangle.h"
#include "tb/claims/measure/over_exponents.h"
#include "tb/claims/measure/patent_constants.h"
#include "tb/golden/angle.h"
#include "tb/golden/interpolation/triangle.h"
#include "tb/golden/registry.h"
#include "tb/golden/scene.h"

namespace blysk::claims {

using namespace golden;
namespace {

std::string answer(std::string_view name, std::vector<double> inputs) {
  try {
    find_model(name)->value(inputs);
  } catch (const std::domain_error&) {
    return "refused";
  }
  return "accepted";
}

const error_summary& at_exponent(lobe which, int n) {
  return errors_of(which)[static_cast<std::size_t>(n) - 1];
}

figures lines_of_a() {
  figures result{{"offset", exact_coefficient(1000.0) - 1000 * coefficient_slope<double>()}};
  for (const auto& [key, which] : {std::pair{"published", lobe::quadratic_published},
                                   {"derived", lobe::quadratic_derived},
                                   {"exact", lobe::quadratic_exact}}) {
    for (const int n : {1, 2, 10, 100, 1000})
      result[fmt::format("{}_{}", key, n)] = at_exponent(which, n).whole.value;
  }
  return result;
}

figures constant_bits() {
  figures result;
  for (const auto& [key, bits] :
       {std::pair{"eight", kConstants[0]}, {"zero", kConstants[1]}, {"one", kConstants[2]}}) {
    result[key] = fixed_point(bits);
    result[fmt::format("{}_off", key)] = fixed_point(bits) - 0.786;
  }
  return result;
}

figures least_of_the_parabola() {
  const auto lowest = [](lobe which) {
    return largest([&](double c) { return -evaluate(which, 1000.0, c); }, 1000, 0, 1);
  };
  return {{"published", -lowest(lobe::quadratic_published).value},
          {"derived", -lowest(lobe::quadratic_derived).value},
          {"cos", lowest(lobe::quadratic_derived).cos}};
}

figures readings_of_the_term() {
  figures result;
  for (const auto& [key, which] : {std::pair{"A", lobe::schlick_modified_a},
                                   {"B", lobe::schlick_modified_b},
                                   {"C", lobe::schlick_modified_c},
                                   {"D", lobe::schlick_modified}}) {
    add_worst_percent(result, key, worst_relative(which, epicentre::level_060));
    result[fmt::format("{}_100", key)] = in_percent(at_exponent(which, 100).relative[0].value);
  }
  return result;
}

double energy_at_all(lobe which) {
  double most = 0;
  for (int n = 1; n <= kMaxExponent; ++n) {
    for (const double degrees : {0.0, 30.0, 60.0, 80.0})
      most = std::max(most, lobe_reflectance(which, n, lobe_axis::half_vector, degrees));
  }
  return most;
}

constexpr double kQ = 0.5;

figures axes_of_the_integral() {
  const double coefficient_100 = angle_coefficient_exact(100.0, 2.0, kQ);
  return {{"mirror", angle_reflectance(100, 2, kQ, coefficient_100, lobe_axis::mirror, 0)},
          {"half", angle_reflectance(100, 2, kQ, coefficient_100, lobe_axis::half_vector, 0)}};
}

figures ends_of_the_integral() {
  return {
      {"n1", angle_limit(1.0, 5.0, kQ)},
      {"n4", angle_limit(4.0, 5.0, kQ)},
      {"n5", angle_limit(5.0, 5.0, kQ)},
      {"clipped", angle_reflectance(1, 5, kQ, angle_coefficient_exact(1.0, 5.0, kQ), lobe_axis::mirror, 0)}};
}

figures levels_of_epicentres() {
  figures result;
  for (const epicentre where : kEpicentres) {
    for (const int n : {2, 1000})
      result[fmt::format("level_{}_{}", key_of(where), n)] = std::pow(epicentre_edge(where, n), n);
  }
  return result;
}

figures opposite_light() {
  const vec3<double> light = normalised(vec3<double>{0.4, 0.5, 0.75});
  const auto half_vec = half_vector(light, -1.0 * light);
  return {{"length", std::sqrt(dot(half_vec, half_vec))}, {"cos", clamped_cosine(light, half_vec)}};
}

/// How far the listing with one of its slips is from the six intensities at most, over them all.
double largest_miss(const listing_slips& slips) {
  const quadratic_surface<double> surface = surface_of_listing(kTriangle, kIntensities, slips);
  double miss = 0;
  for (const node& each : kNodes)
    miss = std::max(miss, std::abs(surface.at(each.x, each.y) - kIntensities.*each.intensity));
  return miss;
}

/// The largest coefficient of the second degree, with the means of the vertices at the middles.
double second_degree_of_means() {
  const auto& [i1, i2, i3, i12, i13, i23] = kIntensities;
  const quadratic_surface<double> surface =
      surface_of_listing(kTriangle, {i1, i2, i3, (i1 + i2) / 2, (i1 + i3) / 2, (i2 + i3) / 2}, {});
  return std::max({std::abs(surface.p3), std::abs(surface.p4), std::abs(surface.p5)});
}

}  // namespace

void measure_errata(measurements& into) {
  into["E1"] = lines_of_a;
  into["E2"] = constant_bits;
  into["E3"] = [] {
    return figures{{"zero", 0.786},
                   {"half", coefficient(coefficient_line::published, 1.0)},
                   {"exact", exact_coefficient(1.0)},
                   {"bit_zero", fixed_point("0")},
                   {"bit_one", fixed_point("1")}};
  };
  into["E4"] = least_of_the_parabola;
  into["E5"] = [] { return figures{{"square", std::pow(1 - 1001.0 / 3, 2)}}; };
  into["E6"] = [] { return figures{{"lsb", std::ldexp(1.0, -15)}}; };
  into["E7"] = readings_of_the_term;
  into["E8"] = [] {
    return figures{{"published", energy_at_all(lobe::cosine_quadratic_energy)},
                   {"safe", energy_at_all(lobe::cosine_quadratic_energy_safe)},
                   {"quadratic", energy_at_all(lobe::quadratic_energy_safe)}};
  };
  into["E9"] = axes_of_the_integral;
  into["E10"] = [] {
    return figures{{"gap", answer("angle-coef-fitted", {10, 2, 0.45})},
                   {"equal", answer("angle-coef-fitted", {2, 2, 0.5})},
                   {"exact", angle_coefficient_exact(10.0, 2.0, 0.45)}};
  };
  into["E11"] = ends_of_the_integral;
  into["E12"] = levels_of_epicentres;
  into["E16"] = [] {
    return figures{{"zero", answer("quadratic-published", {0, 0.5})},
                   {"a", coefficient(coefficient_line::published, 0.0)},
                   {"half", quadratic(coefficient_line::published, 0.0, 0.5)}};
  };
  into["E17"] = opposite_light;
  into["E18"] = [] { return figures{{"coef", angle_coefficient_exact(2.0, 1.0, kQ)}}; };
  into["E19"] = [] {
    return figures{{"term", largest_miss({.term = true})},
                   {"division", largest_miss({.division = true})},
                   {"blue", largest_miss({.blue = true})}};
  };
  into["E20"] = [] { return figures{{"second", second_degree_of_means()}}; };
}

}  // namespace blysk::claims
