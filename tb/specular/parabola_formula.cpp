// SPDX-License-Identifier: Apache-2.0
#include "tb/specular/parabola_formula.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rtl_sysc/formats.h"
#include "tb/golden/lobe_formulas.h"

namespace blysk::specular {
namespace {

golden::coefficient_line line_of(const selection& asked) {
  const std::string& name = asked.value("coefficient");
  if (name == "published") return golden::coefficient_line::published;
  if (name == "derived") return golden::coefficient_line::derived;
  return golden::coefficient_line::exact;
}

/// |bit - golden| <= coefficient + square + rounding + arithmetic, in units of the BRDF:
///   coefficient  |a_wired - a| (c - c^2); clamped, where the lobe ends at c - c^2 = c / a, also
///                <= 1 - min(a_wired, a) / max(a_wired, a)
///   square       a_wired 2^-(diff_bits + 1), if cos^2 is rounded at all
///   rounding     2^-(F + 1)
///   arithmetic   of the golden function itself: three operations on values up to a, each 2^-53 relative
class error_bound {
 public:
  error_bound(const parabola& device, const selection& asked) : is_clamped_(!asked.flag("as-published")) {
    const word_lengths widths = device.widths(asked);
    const int cos_bits = widths.at("cos");
    const int diff_bits = widths.at("square");
    half_ulp_ = std::ldexp(1.0, -cos_bits - 1);
    square_ = diff_bits == 2 * cos_bits ? 0 : std::ldexp(1.0, -diff_bits - 1);
    a_.push_back(0);
    a_wired_.push_back(0);
    for (int n = 1; n <= exponent::max; ++n) {
      a_.push_back(device.coefficient(asked, n));
      a_wired_.push_back(
          std::ldexp(static_cast<double>(device.wired_coefficient(asked, n)), -widths.at("coefficient")));
    }
  }

  double operator()(double n, double c) const {
    const double a = a_[static_cast<std::size_t>(n)];
    const double a_wired = a_wired_[static_cast<std::size_t>(n)];
    double coefficient = std::fabs(a_wired - a) * (c - c * c);
    if (is_clamped_) coefficient = std::fmin(coefficient, 1 - std::fmin(a_wired, a) / std::fmax(a_wired, a));
    return coefficient + a_wired * square_ + half_ulp_ + 3 * a * std::numeric_limits<double>::epsilon() / 2;
  }

 private:
  bool is_clamped_;
  double half_ulp_, square_;
  std::vector<double> a_, a_wired_;  // by n
};

}  // namespace

std::function<double(double, double)> parabola::bound(const selection& asked) const {
  return error_bound(*this, asked);
}

std::string parabola::equation(const selection& asked) const {
  const std::string lobe = "a (c^2 - c) + c";
  const std::string brdf = asked.flag("as-published") ? lobe : "max(0, " + lobe + ")";
  switch (line_of(asked)) {
    case golden::coefficient_line::published:
      return "BRDF = " + brdf + ", a = 0.786 n + 1/2";
    case golden::coefficient_line::derived:
      return "BRDF = " + brdf + ", a = 2 (1 - e^(-1/2)) n - 1/2";
    case golden::coefficient_line::exact:
      break;
  }
  return "BRDF = " + brdf + ", a = (t^(n-1) - 1)/(t - 1), t = sqrt((n-1)/n)";
}

std::function<double(double, double)> parabola::formula(const selection& asked) const {
  const auto line = line_of(asked);
  if (asked.flag("as-published"))
    return [line](double n, double c) { return golden::quadratic<double>(line, n, c); };
  return [line](double n, double c) { return std::clamp(golden::quadratic<double>(line, n, c), 0.0, 1.0); };
}

double parabola::coefficient(const selection& asked, double n) const {
  return golden::coefficient<double>(line_of(asked), n);
}

double parabola::root(const selection& asked, double n) const {
  const double a = coefficient(asked, n);
  return a > 1 ? 1 - 1 / a : 0;
}

option parabola::coefficient_option(const std::vector<std::string>& names,
                                    const std::vector<std::string>& formula_names) {
  return {.name = "coefficient",
          .help = "a = 0.786 n + 0.5 (published), 0.78694 n - 0.5 (derived), formula (9) (exact)",
          .values = names,
          .preset = names.front(),
          .formula_values = formula_names};
}

option parabola::as_published_option() {
  return {.name = "as-published",
          .help = "keep the negative lobe instead of clamping to [0, 1]",
          .values = {"off", "on"},
          .preset = "off"};
}

std::string parabola::lobe_words(const selection& asked) {
  return asked.flag("as-published") ? ", BRDF as published" : ", BRDF clamped to [0, 1]";
}

}  // namespace blysk::specular
