// SPDX-License-Identifier: Apache-2.0
#include "tb/specular/parabola_formula.h"

#include <algorithm>

#include "tb/golden/lobe_formulas.h"

namespace blysk::specular {
namespace {

golden::coefficient_line line_of(const selection& asked) {
  const std::string& name = asked.value("coefficient");
  if (name == "published") return golden::coefficient_line::published;
  if (name == "derived") return golden::coefficient_line::derived;
  return golden::coefficient_line::exact;
}

}  // namespace

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
