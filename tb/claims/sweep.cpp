// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/sweep.h"

#include <map>

#include "tb/claims/words.h"
#include "tb/golden/angle.h"

namespace blysk::claims {

using namespace golden;
namespace {

error_summary measure(const std::function<double(double)>& f, double n) {
  error_summary result{largest_absolute_error(f, n, 0), rms_error(f, n), {}, {}};
  for (std::size_t i = 0; i < kEpicentres.size(); ++i) {
    const double edge = epicentre_edge(kEpicentres[i], n);
    result.relative[i] = largest_relative_error(f, n, edge);
    result.absolute[i] = largest_absolute_error(f, n, edge);
  }
  return result;
}

}  // namespace

std::string at(const worst& w, int digits) {
  return number(w.value, digits) + " (n = " + std::to_string(w.n) + ")";
}

std::string percent_at(const worst& w) {
  return percent(w.value) + " (n = " + std::to_string(w.n) + ")";
}

const std::vector<error_summary>& errors_of(lobe which) {
  static std::map<lobe, std::vector<error_summary>> known;
  auto& result = known[which];
  for (int n = static_cast<int>(result.size()) + 1; n <= kMaxExponent; ++n)
    result.push_back(measure(clamped_lobe(which, n), n));
  return result;
}

const std::vector<error_summary>& errors_of_angle(int k) {
  static std::map<int, std::vector<error_summary>> known;
  auto& result = known[k];
  for (int n = static_cast<int>(result.size()) + 1; n <= kMaxExponent; ++n) {
    result.push_back(
        measure([scale = angle_scale<double>(n, k, 0.5),
                 k](double c) { return angle_lobe_scaled<double>(k, scale * angle_of_cosine(c)); },
                n));
  }
  return result;
}

int first_exponent(epicentre where) {
  return where == epicentre::inflection ? 2 : 1;
}

worst worst_relative(lobe which, epicentre where, int last) {
  const auto& errors = errors_of(which);
  return worst_over(first_exponent(where), last, [&](int n) {
    return errors[static_cast<std::size_t>(n) - 1].relative[static_cast<std::size_t>(where)].value;
  });
}

worst worst_absolute(lobe which, epicentre where, int last) {
  const auto& errors = errors_of(which);
  return worst_over(first_exponent(where), last, [&](int n) {
    return errors[static_cast<std::size_t>(n) - 1].absolute[static_cast<std::size_t>(where)].value;
  });
}

worst worst_whole(lobe which, int last) {
  const auto& errors = errors_of(which);
  return worst_over(1, last, [&](int n) { return errors[static_cast<std::size_t>(n) - 1].whole.value; });
}

double root_cosine(lobe which, double n) {
  const auto parabola = [n](coefficient_line line) { return 1 - 1 / coefficient(line, n); };
  switch (which) {
    case lobe::quadratic_exact:
      return parabola(coefficient_line::exact);
    case lobe::quadratic_published:
      return parabola(coefficient_line::published);
    case lobe::quadratic_derived:
    case lobe::quadratic_energy_safe:
      return parabola(coefficient_line::derived);
    case lobe::cosine_quadratic:
    case lobe::cosine_quadratic_energy:
    case lobe::cosine_quadratic_energy_safe:
      return 1 - 3 / (n + 1);
    case lobe::lyon_2:
      return 1 - 2 / n;
    case lobe::lyon_4:
      return 1 - 4 / n;
    case lobe::lyon_8:
      return 1 - 8 / n;
    case lobe::rational:
      return 1 - 1 / rational_lobe<double>(n).r;
    default:
      return 0;
  }
}

double lobe_reflectance(lobe which, double n, lobe_axis axis, double incidence_degrees) {
  return reflectance_of_cosine(clamped_lobe(which, n), axis,
                               incidence_degrees * boost::math::constants::degree<double>(),
                               root_cosine(which, n));
}

double angle_reflectance(double n, double k, double q, double coefficient, lobe_axis axis,
                         double incidence_degrees) {
  const double limit = angle_limit(n, k, q);
  const double scale = angle_scale(n, k, q);
  return coefficient * reflectance([&](double x) { return angle_lobe_scaled(k, scale * x); }, axis,
                                   incidence_degrees * boost::math::constants::degree<double>(),
                                   std::min(limit, boost::math::constants::half_pi<double>()));
}

}  // namespace blysk::claims
