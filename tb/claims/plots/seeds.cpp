// SPDX-License-Identifier: Apache-2.0
// The curves of [A] and [T], measured again.
#include <algorithm>
#include <cmath>

#include "tb/claims/plots/figure.h"
#include "tb/golden/angle.h"
#include "tb/golden/shift_division.h"

namespace blysk::claims::plots {

using namespace golden;
namespace {

/// Largest relative error, in per cent, of the angle-based lobe (k = 5, Q = 0.5) up to the inflection point.
double angle_error(double n) {
  const double edge = std::atan(1 / std::sqrt(n - 1));
  double result = 0;
  for (const double x : steps(0, edge, 200))
    result = std::max(result, 100 * std::abs(angle_lobe(n, 5.0, 0.5, x) / std::pow(std::cos(x), n) - 1));
  return result;
}

}  // namespace

std::vector<figure> article_figures() {
  const std::vector<double> from6 = exponents(6, 1000);
  return {
      {"article_fig2",
       "[A] fig. 2: angle-based lobe (Q = 0.5, k = 5), Blinn's and Schlick's lobe at n = 50",
       "angle, degrees",
       "value",
       "",
       steps(0, 45, 180),
       {{"angle-based", [](double x) { return angle_lobe(50.0, 5.0, 0.5, x * kDegree); }},
        over_angle("Blinn", lobe::blinn, 50),
        over_angle("Schlick", lobe::schlick, 50)}},
      {"article_fig3",
       "[A] fig. 3: largest relative error up to the inflection point, k = 5, Q = 0.5, and Schlick's",
       "n",
       "error, %",
       "xy",
       from6,
       {{"angle-based", angle_error}, relative("Schlick", lobe::schlick, epicentre::inflection)},
       "[0.1:100]"},
      {"article_fig9",
       "[A] fig. 9: deviation of fitted coef 2 pi Int from 1, k = 5, Q = 0.5",
       "n",
       "deviation",
       "x",
       from6,
       {{"|coef 2 pi Int - 1|",
         [](double n) {
           return std::abs(angle_coefficient_fitted(n, 5.0, 0.5) / angle_coefficient_exact(n, 5.0, 0.5) - 1);
         }}}},
  };
}

std::vector<figure> thesis_figures() {
  const std::vector<double> all = exponents(1, 1000);
  const auto shifts = [](int places) {
    return curve{std::to_string(places) + " shifts", [=](double k) {
                   return 100 * std::abs(shifted_quotient(k, static_cast<uint32_t>(k), places) - 1);
                 }};
  };
  return {
      {"thesis_fig2_2",
       "[T] fig. 2.2: Blinn's lobe and Schlick's at n = 20",
       "angle, degrees",
       "value",
       "",
       steps(0, 90, 180),
       {over_angle("Blinn", lobe::blinn, 20), over_angle("Schlick", lobe::schlick, 20)}},
      {"thesis_fig2_3",
       "[T] fig. 2.3: Schlick's largest relative error where cos^n >= 0.6",
       "n",
       "error, %",
       "x",
       all,
       {relative("Schlick", lobe::schlick, epicentre::level_060)}},
      {"thesis_fig2_4",
       "[T] fig. 2.4: Schlick, Blinn, and the four readings of the modified Schlick at n = 20",
       "angle, degrees",
       "value",
       "",
       steps(0, 60, 180),
       {over_angle("Schlick", lobe::schlick, 20), over_angle("Blinn", lobe::blinn, 20),
        over_angle("reading A", lobe::schlick_modified_a, 20),
        over_angle("reading B", lobe::schlick_modified_b, 20),
        over_angle("reading C", lobe::schlick_modified_c, 20),
        over_angle("reading D", lobe::schlick_modified, 20)}},
      {"thesis_fig2_5",
       "[T] fig. 2.5, [P] (3): quadratic with exact a and Blinn's lobe at n = 20, negative lobe and all",
       "angle, degrees",
       "value",
       "",
       steps(0, 90, 180),
       {over_angle("Blinn", lobe::blinn, 20), over_angle("quadratic, exact a", lobe::quadratic_exact, 20)}},
      {"thesis_fig2_6",
       "[T] fig. 2.6: relative error of the quadratic with exact a at n = 20 down to its root",
       "angle, degrees",
       "error, %",
       "",
       steps(0, std::acos(1 - 1 / exact_coefficient(20.0)) / kDegree, 160),
       {{"quadratic, exact a",
         [](double degrees) {
           const double c = std::cos(degrees * kDegree);
           return 100 * (evaluate(lobe::quadratic_exact, 20.0, c) / blinn(20.0, c) - 1);
         }}}},
      {"thesis_fig2_7",
       "[T] fig. 2.7: the quadratic's largest relative error where cos^n >= 0.56, by line of a",
       "n",
       "error, %",
       "xy",
       exponents(2, 512),
       {relative("exact a", lobe::quadratic_exact, epicentre::level_056),
        relative("derived line", lobe::quadratic_derived, epicentre::level_056),
        relative("published line", lobe::quadratic_published, epicentre::level_056)}},
      {"thesis_fig2_10",
       "[T] fig. 2.10: the cosine-quadratic's largest relative error, by epicentre",
       "n",
       "error, %",
       "x",
       exponents(2, 1000),
       {relative("cos^n >= 0.6", lobe::cosine_quadratic, epicentre::level_060),
        relative("cos^n >= 0.56", lobe::cosine_quadratic, epicentre::level_056),
        relative("up to the inflection point", lobe::cosine_quadratic, epicentre::inflection)}},
      {"thesis_fig2_12",
       "[T] fig. 2.12: relative error of division by shifts",
       "k, pixels",
       "error, %",
       "",
       steps(2, 16, 14),
       {shifts(6), shifts(7), shifts(8)}},
      {"thesis_fig2_15",
       "[T] fig. 2.15: reflectance of the cosine-quadratic at normal incidence; energy is kept below 1",
       "n",
       "R",
       "x",
       all,
       {energy("cosine-quadratic", lobe::cosine_quadratic, lobe_axis::half_vector, 0)}},
      {"thesis_fig2_16",
       "[T] fig. 2.16: reflectance of the normalised lobes at normal incidence, and of the safe ones",
       "n",
       "R",
       "x",
       all,
       {energy("(n+6)/24.55 cosine-quadratic", lobe::cosine_quadratic_energy, lobe_axis::half_vector, 0),
        energy("(n+6)/(8 pi) Blinn", lobe::blinn_normalised, lobe_axis::half_vector, 0),
        energy("(n+1)/(8 pi) cosine-quadratic", lobe::cosine_quadratic_energy_safe, lobe_axis::half_vector,
               0),
        energy("safe quadratic", lobe::quadratic_energy_safe, lobe_axis::half_vector, 0)}},
  };
}

}  // namespace blysk::claims::plots
