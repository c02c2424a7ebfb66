// SPDX-License-Identifier: Apache-2.0
// The project's own curves: errors of every lobe, slopes of the line of a, reflectance by incidence.
#include "tb/claims/plots/figure.h"
#include "tb/claims/slopes.h"

namespace blysk::claims::plots {

using namespace golden;

std::vector<figure> own_figures() {
  const std::vector<double> all = exponents(1, 1000);
  const std::vector<double> from2 = exponents(2, 1000);
  figure whole{"errors_whole",
               "Largest absolute error against cos^n over the whole range, lobes limited to [0, 1]",
               "n",
               "error",
               "x",
               all,
               {}};
  figure inside{"errors_epicentre",
                "Largest relative error against cos^n where cos^n >= 0.56",
                "n",
                "error, %",
                "xy",
                from2,
                {}};
  for (const auto& [title, which] : {std::pair{"Schlick", lobe::schlick},
                                     {"Schlick modified", lobe::schlick_modified},
                                     {"quadratic, derived", lobe::quadratic_derived},
                                     {"cosine-quadratic", lobe::cosine_quadratic},
                                     {"Lyon 2", lobe::lyon_2},
                                     {"Lyon 8", lobe::lyon_8},
                                     {"GX", lobe::gx},
                                     {"rational", lobe::rational}}) {
    whole.curves.push_back(
        over_exponents(title, which, [](const error_summary& e) { return e.whole.value; }));
    inside.curves.push_back(relative(title, which, epicentre::level_056));
  }
  return {
      whole,
      inside,
      {"slope_front",
       "Line a = slope n - 1/2: epicentre against whole-range error, a mark each 0.05",
       "largest absolute error, whole range",
       "largest relative error, epicentre",
       "",
       steps(0.3, 1, 14),
       {{"cos^n >= 0.56, slope from 0.3 (top right) to 1",
         [](double s) { return slope_error(s, slope_axis::epicentre, 1); }},
        {"the same without n = 1", [](double s) { return slope_error(s, slope_axis::epicentre, 2); }},
        {"up to the inflection point, from n = 2",
         [](double s) { return slope_error(s, slope_axis::inflection, 2); }}},
       "[0:*]",
       "linespoints lw 2 pt 7 ps 0.7",
       [](double s) { return slope_error(s, slope_axis::whole, 1); }},
      {"slope_errors",
       "Slope of the line a = slope n - 1/2: whole range against epicentre",
       "slope",
       "error",
       "",
       steps(0.2, 1.1, 90),
       {{"largest absolute, whole range", [](double s) { return slope_error(s, slope_axis::whole, 1); }},
        {"largest relative, cos^n >= 0.56",
         [](double s) { return slope_error(s, slope_axis::epicentre, 1); }},
        {"the same without n = 1", [](double s) { return slope_error(s, slope_axis::epicentre, 2); }},
        {"largest relative, to the inflection point",
         [](double s) { return slope_error(s, slope_axis::inflection, 2); }}}},
      {"line_of_a",
       "[P] (10): distance of three lines from (9)",
       "n",
       "line - (9)",
       "x",
       from2,
       {{"0.786 n + 0.5", [](double n) { return 0.786 * n + 0.5 - exact_coefficient(n); }},
        {"0.786 n - 0.5", [](double n) { return 0.786 * n - 0.5 - exact_coefficient(n); }},
        {"2 (1 - e^{-1/2}) n - 0.5",
         [](double n) { return coefficient(coefficient_line::derived, n) - exact_coefficient(n); }}}},
      {"energy_oblique",
       "Reflectance of the published and the safe cosine-quadratic by incidence, n = 17",
       "incidence, degrees",
       "R",
       "",
       steps(0, 88, 88),
       {{"(n+6)/24.55",
         [](double d) {
           return lobe_reflectance(lobe::cosine_quadratic_energy, 17, lobe_axis::half_vector, d);
         }},
        {"(n+1)/(8 pi)",
         [](double d) {
           return lobe_reflectance(lobe::cosine_quadratic_energy_safe, 17, lobe_axis::half_vector, d);
         }}}},
  };
}

}  // namespace blysk::claims::plots
