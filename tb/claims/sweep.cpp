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

}  // namespace blysk::claims
