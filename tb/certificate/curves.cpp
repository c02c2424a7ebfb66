// SPDX-License-Identifier: Apache-2.0
#include "tb/certificate/curves.h"

#include <algorithm>
#include <ios>

#include "tb/golden/coefficient.h"
#include "tb/golden/lobe_formulas.h"

namespace blysk {
namespace {

using golden::referee;

const referee& ln2() {
  static const referee value = log(referee(2));
  return value;
}

/// -log2(1 - v/2)/v at the distance v = 1 - x, and its derivative by x.
referee log_ratio(const referee& x) {
  const referee v = 1 - x;
  return v == 0 ? 1 / (2 * ln2()) : referee(-log1p(referee(-v / 2)) / (v * ln2()));
}
referee log_ratio_slope(const referee& x) {
  const referee v = 1 - x;
  if (v == 0) return -1 / (8 * ln2());
  return -(v / (2 - v) + log1p(referee(-v / 2))) / (v * v * ln2());
}

/// More than the functions are off by.
const referee& apart() {
  static const referee value = pow(referee(10), -34);
  return value;
}

}  // namespace

const std::map<std::string, number_of_exponent>& numbers_of() {
  static const std::map<std::string, number_of_exponent> all{
      {"exact_coefficient", [](const referee& n) { return golden::exact_coefficient(n); }},
      {"power_at_root",
       [](const referee& n) {
         return n <= 2 ? referee(0) : golden::blinn<referee>(n, referee((n - 2) / (n + 1)));
       }},
      {"rational_fall", [](const referee& n) { return golden::rational_lobe<referee>(n).r; }},
      {"rational_rise", [](const referee& n) {
         const golden::rational_lobe<referee> lobe(n);
         return referee(lobe.s - lobe.r);
       }}};
  return all;
}

const std::map<std::string, convex_curve>& convex_curves() {
  static const std::map<std::string, convex_curve> all{
      {"decay",
       {[](const referee& x) { return referee(exp(referee(-x))); },
        [](const referee& x) { return referee(-exp(referee(-x))); }}},
      {"half_power",
       {[](const referee& x) { return referee(exp(referee(-x * ln2()))); },
        [](const referee& x) { return referee(-ln2() * exp(referee(-x * ln2()))); }}},
      {"log_ratio", {log_ratio, log_ratio_slope}}};
  return all;
}

digits_range outward(const referee& low, const referee& high) {
  constexpr int kDigits = 40;
  const auto digits = [](const referee& of) { return of.str(kDigits, std::ios_base::fixed); };
  return {digits(low - apart()), digits(high + apart())};
}

errors_of_lines compare(const stored_lines& lines, const convex_curve& curve, std::size_t first,
                        std::size_t last) {
  referee low = 1, high = -1, relative_low = 1, relative_high = -1;
  for (std::size_t i = first; i <= last; ++i) {
    const referee begin = ldexp(referee(lines.begins[i]), -lines.begin_frac) - lines.half;
    const referee end = begin + ldexp(referee(lines.changes[i]), -lines.change_frac);
    const referee x0 = lines.from + lines.length * i;
    const referee x1 = x0 + lines.length;
    const referee y0 = curve.value(x0);
    const referee y1 = curve.value(x1);
    const referee least = std::min(referee(begin - y0), referee(end - y1));
    const referee s0 = curve.slope(x0);
    const referee s1 = curve.slope(x1);
    const referee share = ((end - begin) / lines.length - s0) / (s1 - s0);
    const referee middle = x0 + lines.length * std::clamp(share, referee(0), referee(1));
    const referee at = curve.value(middle);
    const referee slope = curve.slope(middle);
    const referee most =
        std::max(referee(begin - at - slope * (x0 - middle)), referee(end - at - slope * (x1 - middle)));
    low = std::min(low, least);
    high = std::max(high, most);
    relative_low = std::min(relative_low, referee(least / (least < 0 ? y1 : y0)));
    relative_high = std::max(relative_high, referee(most / (most < 0 ? y0 : y1)));
  }
  return {outward(low, high), outward(relative_low, relative_high)};
}

digits_range range_of_curve(const stored_lines& lines, const convex_curve& curve, std::size_t first,
                            std::size_t last) {
  return outward(curve.value(lines.from + lines.length * (last + 1)),
                 curve.value(lines.from + lines.length * first));
}

}  // namespace blysk
