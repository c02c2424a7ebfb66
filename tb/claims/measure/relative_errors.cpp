// SPDX-License-Identifier: Apache-2.0
// [T]: relative errors in the highlight, in per cent.
#include <fmt/format.h>

#include <cmath>

#include "tb/claims/measure/over_exponents.h"
#include "tb/claims/table_form.h"
#include "tb/claims/words.h"

namespace blysk::claims {

using namespace golden;
namespace {

/// Something that stands for cos^n, and its largest relative error by epicentre and exponent.
struct candidate {
  std::string key;
  std::function<double(epicentre where, int n)> error;
};

double lobe_error(lobe which, epicentre where, int n) {
  return errors_of(which)[static_cast<std::size_t>(n) - 1].relative[static_cast<std::size_t>(where)].value;
}

candidate of_lobe(std::string key, lobe which) {
  return {std::move(key), [which](epicentre where, int n) { return lobe_error(which, where, n); }};
}

const std::vector<candidate>& schlick_alone() {
  static const std::vector<candidate> result{of_lobe("schlick", lobe::schlick)};
  return result;
}

/// What (2.2) can mean, and what table 3.2 prints in its place.
const std::vector<candidate>& modified() {
  static const std::vector<candidate> result{of_lobe("A", lobe::schlick_modified_a),
                                             of_lobe("B", lobe::schlick_modified_b),
                                             of_lobe("C", lobe::schlick_modified_c),
                                             of_lobe("D", lobe::schlick_modified),
                                             {"E", table_form_error}};
  return result;
}

const std::vector<candidate>& quadratics() {
  static const std::vector<candidate> result{of_lobe("exact", lobe::quadratic_exact),
                                             of_lobe("published", lobe::quadratic_published),
                                             of_lobe("derived", lobe::quadratic_derived)};
  return result;
}

worst worst_of(const candidate& c, epicentre where, int last = kMaxExponent) {
  return worst_over(first_exponent(where), last, [&](int n) { return c.error(where, n); });
}

/// Largest error of each candidate in each epicentre, where it lies, and the n that meet the limit.
figures against(const std::vector<candidate>& candidates, double limit, int last = kMaxExponent) {
  figures result;
  for (const candidate& each : candidates) {
    for (const epicentre where : kEpicentres) {
      const std::string key = fmt::format("{}_{}", each.key, key_of(where));
      add_worst_percent(result, key, worst_of(each, where, last));
      result[key + "_met"] =
          exponents_where(first_exponent(where), last, [&](int n) { return each.error(where, n) <= limit; });
    }
  }
  return result;
}

void measure_schlick(measurements& into) {
  into["T1"] = [] { return against(schlick_alone(), 0.032); };
  into["T2"] = [] {
    figures result;
    for (const epicentre where : kEpicentres)
      add_worst_percent(result, fmt::format("schlick_{}", key_of(where)),
                        worst_relative(lobe::schlick, where));
    return result;
  };
  into["T42"] = [] {
    figures result{{"limit", in_percent(1 / (0.6 * (1 - std::log(0.6))) - 1)}};
    for (const int n : {1, 2, 10, 100, 1000})
      result[fmt::format("n{}", n)] = in_percent(lobe_error(lobe::schlick, epicentre::level_060, n));
    return result;
  };
  into["T4"] = [] { return against(modified(), 0.032); };
  into["T5"] = [] { return against(modified(), 0.004); };
  into["T6"] = [] {
    figures result{{"own", 10 - 3.2}};
    for (const candidate& each : modified()) {
      for (const epicentre where : kEpicentres)
        result[fmt::format("{}_{}", each.key, key_of(where))] =
            in_percent(worst_relative(lobe::schlick, where).value - worst_of(each, where).value);
    }
    return result;
  };
  into["T7"] = [] {
    figures result;
    for (const epicentre where : kEpicentres)
      add_worst_percent(result, fmt::format("E_{}", key_of(where)), worst_of(modified().back(), where));
    return result;
  };
}

void measure_quadratics(measurements& into) {
  into["T8"] = [] { return against(quadratics(), 0.03); };
  into["T9"] = [] {
    const double tail =
        largest_relative_error(clamped_lobe(lobe::quadratic_exact, 100), 100, std::pow(0.1, 0.01)).value;
    return figures{{"tail", in_percent(tail)},
                   {"end", std::pow(root_cosine(lobe::quadratic_exact, 100), 100)}};
  };
  into["T10"] = [] { return against(quadratics(), 0.02); };
  into["T11"] = [] { return against(quadratics(), 0.03, 512); };
  into["T12"] = [] {
    figures result;
    for (const epicentre where : kEpicentres) {
      result[fmt::format("ratio_{}", key_of(where))] =
          worst_relative(lobe::schlick, where).value / worst_relative(lobe::quadratic_exact, where).value;
      result[fmt::format("met_{}", key_of(where))] =
          exponents_where(first_exponent(where), kMaxExponent, [&](int n) {
            const double schlick = lobe_error(lobe::schlick, where, n);
            return schlick > kRounding && schlick >= 10 * lobe_error(lobe::quadratic_exact, where, n);
          });
    }
    return result;
  };
}

void measure_cosine_quadratic(measurements& into) {
  into["T17"] = [] { return against({of_lobe("cq", lobe::cosine_quadratic)}, 0.03); };
  into["T44"] = [] {
    figures result;
    for (const int n : {1, 2, 10, 100, 1000}) {
      const std::string key = fmt::format("n{}", n);
      result[key + "_060"] = in_percent(lobe_error(lobe::cosine_quadratic, epicentre::level_060, n));
      result[key + "_point"] =
          in_percent(cosine_quadratic<double>(n, n / (n + 1.0)) / std::pow(n / (n + 1.0), n) - 1);
    }
    return result;
  };
}

}  // namespace

void measure_relative_errors(measurements& into) {
  measure_schlick(into);
  measure_quadratics(into);
  measure_cosine_quadratic(into);
}

}  // namespace blysk::claims
