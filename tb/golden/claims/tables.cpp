// SPDX-License-Identifier: Apache-2.0
// Errors, energy and stability by exponent: the pages under docs/tables that the rows refer to.
#include <cmath>
#include <limits>

#include "tb/golden/angle.h"
#include "tb/golden/claims/claim.h"
#include "tb/golden/claims/slopes.h"
#include "tb/golden/claims/sweep.h"
#include "tb/golden/naive.h"
#include "tb/golden/referee.h"

namespace blysk::golden {
namespace {

constexpr std::array kListed{1, 2, 3, 5, 10, 20, 50, 100, 200, 500, 1000};

std::vector<std::string> head_of(std::string_view first) {
  std::vector<std::string> result{std::string(first)};
  for (const int n : kListed) result.push_back(std::to_string(n));
  return result;
}

/// One row per lobe: metric at the listed exponents, then its largest over all from the first on.
template <class Metric>
std::string by_exponent(const Metric& metric, int first = 1) {
  auto head = head_of("lobe \\ n");
  head.push_back("largest, at n");
  std::vector<std::vector<std::string>> rows{head};
  for (const lobe which : kApproximations) {
    rows.push_back({std::string(name_of(which))});
    const auto& errors = errors_of(which);
    const auto value = [&](int n) { return metric(errors[static_cast<std::size_t>(n) - 1]); };
    for (const int n : kListed) rows.back().push_back(n < first ? "-" : number(value(n)));
    const worst w = worst_over(first, kMaxExponent, value);
    rows.back().push_back("**" + number(w.value) + "**, " + std::to_string(w.n));
  }
  return markdown(rows);
}

}  // namespace

std::vector<table> error_tables() {
  std::string text =
      "# Errors against cos^n\n\nLobes limited to [0, 1] as the devices do. The last column is the largest "
      "over every "
      "n in 1..1000. Whole range and epicentre trade against each other: see the front at the end.\n"
      "\n## Largest absolute error, cos in [0, 1]\n\n" +
      by_exponent([](const error_summary& e) { return e.whole.value; }) +
      "\n## Where it lies, as the value of cos^n there\n\n";
  auto rows = std::vector<std::vector<std::string>>{head_of("lobe \\ n")};
  for (const lobe which : kApproximations) {
    rows.push_back({std::string(name_of(which))});
    for (const int n : kListed) {
      const peak& whole = errors_of(which)[static_cast<std::size_t>(n) - 1].whole;
      rows.back().push_back(whole.value < kRounding ? "-" : number(std::pow(whole.cos, n), 2));
    }
  }
  text += markdown(rows) + "\n## Root mean square error over cos in [0, 1]\n\n" +
          by_exponent([](const error_summary& e) { return e.rms; });
  for (const epicentre where : kEpicentres) {
    const auto index = static_cast<std::size_t>(where);
    text +=
        "\n## Epicentre: " + std::string(name_of(where)) + "\n\nLargest relative error\n\n" +
        by_exponent([=](const error_summary& e) { return e.relative[index].value; }, first_exponent(where)) +
        "\nLargest absolute error\n\n" +
        by_exponent([=](const error_summary& e) { return e.absolute[index].value; }, first_exponent(where));
  }

  struct column {
    std::string name;
    slope_axis axis;
    int first;
  };
  const std::vector<column> columns{
      {"largest absolute error, whole range, n = 1..1000", slope_axis::whole, 1},
      {"largest relative error, c^n >= 0.56, n = 1..1000", slope_axis::epicentre, 1},
      {"the same, n = 2..1000", slope_axis::epicentre, 2},
      {"largest relative error, up to the inflection point, n = 2..1000", slope_axis::inflection, 2}};
  rows = {{"slope"}};
  for (const column& c : columns) rows.front().push_back(c.name);
  const auto add_row = [&](double slope, std::string name) {
    rows.push_back({std::move(name)});
    for (const column& c : columns) rows.back().push_back(number(slope_error(slope, c.axis, c.first)));
  };
  for (int i = 20; i <= 100; i += 4) add_row(i / 100.0, number(i / 100.0));
  rows.push_back({"**best slope**"});
  for (const column& c : columns) {
    const double slope = best_slope(c.axis, c.first);
    rows.back().push_back("**" + number(slope, 4) + "**, error " +
                          number(slope_error(slope, c.axis, c.first)));
  }
  text +=
      "\n## Slope of the line a = slope n - 1/2\n\n(9) expanded gives 0.7869, [P] prints 0.786. At n = 1 the "
      "lobe "
      "is a line, a = 0, which the slope 1/2 meets; that one exponent decides the second column, so the "
      "third "
      "leaves it out. Slopes between the best of the whole range and the best of an epicentre form the "
      "front: "
      "there neither error falls without the other rising.\n\n" +
      markdown(rows);
  return {{"errors.md", text}};
}

std::vector<table> energy_tables() {
  std::string text =
      "# Directional-hemispherical reflectance R\n\nA lobe obeys the conservation of energy where R <= 1. "
      "Two readings "
      "of the lobe's angle: from the half vector to the normal, and from the outgoing ray to the mirror "
      "direction. "
      "Incidence in degrees. Negative lobes are set to zero. The last columns list the n in 1..1000 with R > "
      "1.\n";
  for (const lobe_axis axis : {lobe_axis::half_vector, lobe_axis::mirror}) {
    text += axis == lobe_axis::half_vector ? "\n## Angle to the half vector\n\n"
                                           : "\n## Angle to the mirror direction\n\n";
    std::vector<std::vector<std::string>> rows{{"lobe", "R(1) at 0", "R(10) at 0", "R(100) at 0",
                                                "R(1000) at 0", "largest R at 0", "at 30", "at 60", "at 80",
                                                "R > 1 at 0", "R > 1 at 0, 30, 60 or 80"}};
    for (const auto& [which, name] : kLobes) {
      rows.push_back({std::string(name)});
      for (const int n : {1, 10, 100, 1000})
        rows.back().push_back(number(lobe_reflectance(which, n, axis, 0), 4));
      std::vector<bool> anywhere(kMaxExponent, false);
      std::vector<bool> normal(kMaxExponent, false);
      for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
        worst most{-1, 1};
        for (int n = 1; n <= kMaxExponent; ++n) {
          const double r = lobe_reflectance(which, n, axis, degrees);
          const auto index = static_cast<std::size_t>(n) - 1;
          anywhere[index] = anywhere[index] || r > 1;
          if (degrees == 0) normal[index] = r > 1;
          if (r > most.value) most = {r, n};
        }
        rows.back().push_back(at(most, 4));
      }
      rows.back().push_back(ranges(normal));
      rows.back().push_back(ranges(anywhere));
    }
    text += markdown(rows);
  }
  return {{"energy.md", text}};
}

namespace {

/// Error of a value in roundoffs of its type, relative to the exact one. Below two, versions of the mathematical library
/// differ.
template <class Real>
std::string roundoffs(const Real& value, const referee& exact) {
  if (!std::isfinite(value)) return "not finite";
  const auto error = static_cast<double>(abs(referee(value) / exact - 1) / roundoff<Real>());
  return error < 2 ? "< 2" : number(error, 2);
}

/// Literal and stable form at one point in float and double, as a row.
template <class Literal, class Stable>
std::vector<std::string> compare(std::string what, const Literal& literal, const Stable& stable) {
  return {std::move(what), roundoffs(literal(float{}), stable(float{}, referee{})),
          roundoffs(stable(float{}, float{}), stable(float{}, referee{})),
          roundoffs(literal(double{}), stable(double{}, referee{})),
          roundoffs(stable(double{}, double{}), stable(double{}, referee{}))};
}

}  // namespace

std::vector<table> stability_tables() {
  std::vector<std::vector<std::string>> rows{
      {"formula and point", "float, literal", "float, stable", "double, literal", "double, stable"}};
  // Each functor takes the argument type first: the point is rounded to it, then computed in the second type.
  for (const int n : {2, 10, 100, 300, 1000})
    rows.push_back(compare(
        "(9), n = " + std::to_string(n),
        [n](auto real) { return naive::exact_coefficient(decltype(real)(n)); },
        [n](auto, auto in) { return exact_coefficient(decltype(in)(n)); }));
  for (const auto& [n, q] :
       {std::pair{10.0, 0.5}, {1000.0, 0.5}, {1000.0, 0.9}, {10.0, 0.9999}, {1000.0, 0.9999}})
    rows.push_back(compare(
        "acos(q^(1/n)), n = " + number(n, 4) + ", q = " + number(q, 4),
        [n = n, q = q](auto real) { return naive::angle_of_level(decltype(real)(n), decltype(real)(q)); },
        [n = n, q = q](auto real, auto in) {
          return angle_of_level(decltype(in)(n), decltype(in)(decltype(real)(q)));
        }));
  for (const auto& [n, c] : {std::pair{50.0, 0.9997}, {1000.0, 0.9997}, {1000.0, 0.99999}}) {
    rows.push_back(compare(
        "Schlick, n = " + number(n, 4) + ", c = " + number(c, 5),
        [n = n, c = c](auto real) { return naive::schlick(decltype(real)(n), decltype(real)(c)); },
        [n = n, c = c](auto real, auto in) {
          return schlick(decltype(in)(n), decltype(in)(decltype(real)(c)));
        }));
    rows.push_back(compare(
        "gx, n = " + number(n, 4) + ", c = " + number(c, 5),
        [n = n, c = c](auto real) { return naive::gx(decltype(real)(n), decltype(real)(c)); },
        [n = n, c = c](auto real, auto in) { return gx(decltype(in)(n), decltype(in)(decltype(real)(c))); }));
    rows.push_back(compare(
        "a c^2 + (1 - a) c, a = 0.75 n, n = " + number(n, 4) + ", c = " + number(c, 5),
        [n = n, c = c](auto real) { return naive::quadratic(decltype(real)(0.75 * n), decltype(real)(c)); },
        [n = n, c = c](auto real, auto in) {
          return quadratic(decltype(in)(0.75 * n), decltype(in)(decltype(real)(c)));
        }));
  }
  for (const double y : {0.1, 1e-3, 1e-5})
    rows.push_back(compare(
        "1 - cos(y), y = " + number(y), [y](auto real) { return naive::versine(decltype(real)(y)); },
        [y](auto real, auto in) {
          using std::sin;
          const decltype(in) s = sin(decltype(in)(decltype(in)(decltype(real)(y)) / 2));
          return decltype(in)(2 * s * s);
        }));

  std::vector<std::vector<std::string>> bits{{"n", "worst slope of cos^n", "bits for half an 8-bit step"}};
  for (const int n : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000}) {
    // |d c^n / dc| <= n; a cosine rounded to f bits is off by 2^-(f+1), half an 8-bit step is 1/510.
    bits.push_back({std::to_string(n), std::to_string(n), number(std::ceil(std::log2(n * 510.0) - 1))});
  }
  return {{"stability.md",
           "# Literal and stable forms: relative error in roundoffs (2^-24, 2^-53)\n\nThe exact value is the "
           "stable form "
           "in 50 digits at the point as float or double holds it. The tests labelled `stability` bound "
           "every stable "
           "form; these are single points.\n\n" +
               markdown(rows) +
               "\n## Fraction bits of the cosine\n\nThe condition number of cos^n near cos = 1 is n: f "
               "fraction bits, "
               "rounded, move the result by n 2^-(f+1).\n\n" +
               markdown(bits)}};
}

}  // namespace blysk::golden
