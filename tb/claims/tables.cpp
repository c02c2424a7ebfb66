// SPDX-License-Identifier: Apache-2.0
// Errors, energy and stability by exponent: the pages under docs/tables that the rows refer to.
#include <algorithm>
#include <cmath>
#include <functional>

#include "tb/claims/claim.h"
#include "tb/claims/slopes.h"
#include "tb/claims/sweep.h"
#include "tb/golden/angle.h"
#include "tb/golden/hard_forms.h"
#include "tb/golden/scene.h"

namespace blysk::golden {
namespace {

constexpr std::array kListed{1, 2, 3, 5, 10, 20, 50, 100, 200, 500, 1000};

std::vector<std::string> head_of(std::string_view first) {
  std::vector<std::string> result{std::string(first)};
  for (const int n : kListed) result.push_back(std::to_string(n));
  return result;
}

/// The lobes of kApproximations and the angle-based one at Q = 0.5, by name.
std::vector<std::pair<std::string, const std::vector<error_summary>*>> approximations() {
  std::vector<std::pair<std::string, const std::vector<error_summary>*>> result;
  result.reserve(std::size(kApproximations) + 5);
  for (const lobe which : kApproximations) result.emplace_back(name_of(which), &errors_of(which));
  for (int k = 1; k <= 5; ++k)
    result.emplace_back("angle, Q = 0.5, k = " + std::to_string(k), &errors_of_angle(k));
  return result;
}

/// Text of a number at each listed exponent, one row per approximation; last(errors) in a further column.
template <class Cell, class Last>
std::string by_exponent(std::string last_head, int first, const Cell& cell, const Last& last) {
  auto head = head_of("lobe \\ n");
  head.push_back(std::move(last_head));
  std::vector<std::vector<std::string>> rows{head};
  for (const auto& [name, errors] : approximations()) {
    rows.push_back({name});
    for (const int n : kListed)
      rows.back().push_back(n < first ? "-" : cell(n, (*errors)[static_cast<std::size_t>(n) - 1]));
    rows.back().push_back(last(*errors));
  }
  return markdown(rows);
}

/// Value of cos^n where an error is largest; none where there is nothing but rounding.
std::string place_of(int n, const peak& error) {
  return error.value < kRounding ? "-" : number(std::pow(error.cos, n), 2);
}

/// Table of an error, and of where it lies: metric(summary) is a peak.
template <class Metric>
std::string errors_and_places(const Metric& metric, int first = 1) {
  const auto worst_of_all = [&](const std::vector<error_summary>& errors) {
    return worst_over(first, kMaxExponent,
                      [&](int n) { return metric(errors[static_cast<std::size_t>(n) - 1]).value; });
  };
  return by_exponent(
             "largest, at n", first, [&](int, const error_summary& e) { return number(metric(e).value); },
             [&](const std::vector<error_summary>& errors) {
               const worst w = worst_of_all(errors);
               return "**" + number(w.value) + "**, " + std::to_string(w.n);
             }) +
         "\nIt lies where cos^n is\n\n" +
         by_exponent(
             "for the largest", first, [&](int n, const error_summary& e) { return place_of(n, metric(e)); },
             [&](const std::vector<error_summary>& errors) {
               const int n = worst_of_all(errors).n;
               return place_of(n, metric(errors[static_cast<std::size_t>(n) - 1]));
             });
}

}  // namespace

std::vector<table> error_tables() {
  std::string text =
      "# Errors against cos^n\n\nLobes limited to [0, 1] as the devices do. The last column is the largest "
      "over every "
      "n in 1..1000. Whole range and epicentre trade against each other: see the front at the end.\n"
      "\n## Largest absolute error, cos in [0, 1]\n\n" +
      errors_and_places([](const error_summary& e) { return e.whole; }) +
      "\n## Root mean square error over cos in [0, 1]\n\n" +
      by_exponent(
          "largest, at n", 1, [](int, const error_summary& e) { return number(e.rms); },
          [](const std::vector<error_summary>& errors) {
            const worst w = worst_over(1, kMaxExponent,
                                       [&](int n) { return errors[static_cast<std::size_t>(n) - 1].rms; });
            return "**" + number(w.value) + "**, " + std::to_string(w.n);
          });
  for (const epicentre where : kEpicentres) {
    const auto index = static_cast<std::size_t>(where);
    text +=
        "\n## Epicentre: " + std::string(name_of(where)) + "\n\nLargest relative error\n\n" +
        errors_and_places([=](const error_summary& e) { return e.relative[index]; }, first_exponent(where)) +
        "\nLargest absolute error\n\n" +
        errors_and_places([=](const error_summary& e) { return e.absolute[index]; }, first_exponent(where));
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
  std::vector<std::vector<std::string>> rows{{"slope"}};
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

namespace {

constexpr std::array kIncidences{0.0, 30.0, 60.0, 80.0};  // degrees
constexpr std::array kAxes{lobe_axis::half_vector, lobe_axis::mirror};
constexpr std::array kLevels{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};

std::string heading(lobe_axis axis) {
  return axis == lobe_axis::half_vector ? "Angle to the half vector" : "Angle to the mirror direction";
}

std::string cook_torrance_table() {
  std::vector<std::vector<std::string>> rows{{"D", "m"}};
  for (const double degrees : kIncidences) rows.front().push_back("at " + number(degrees));
  for (const auto distribution : {facet_distribution::gaussian, facet_distribution::beckmann}) {
    for (const double m : {0.1, 0.2, 0.3, 0.5, 1.0}) {
      rows.push_back({distribution == facet_distribution::gaussian ? "Gaussian" : "Beckmann", number(m)});
      for (const double degrees : kIncidences)
        rows.back().push_back(number(cook_torrance_reflectance(distribution, m, 1.5, degrees), 3));
    }
  }
  return markdown(rows);
}

/// Around the mirror direction: what lies beyond 90 degrees, for lobes that are not 0 there.
std::string beyond_table() {
  std::vector<std::vector<std::string>> rows{{"lobe", "n"}};
  for (const double degrees : kIncidences) {
    if (degrees > 0) rows.front().push_back("at " + number(degrees) + ": dark, clipped, formula");
  }
  const std::pair<lobe, int> cases[] = {{lobe::cosine_quadratic, 1}, {lobe::lyon_2, 1}, {lobe::lyon_4, 1},
                                        {lobe::lyon_4, 2},           {lobe::lyon_8, 1}, {lobe::lyon_8, 2},
                                        {lobe::lyon_8, 4},           {lobe::lyon_8, 7}};
  for (const auto& [which, n] : cases) {
    rows.push_back({std::string(name_of(which)), std::to_string(n)});
    for (const double degrees : kIncidences) {
      if (!(degrees > 0)) continue;
      std::string cell;
      for (const auto beyond :
           {beyond_right_angle::dark, beyond_right_angle::clipped, beyond_right_angle::formula})
        append(cell, ", ", number(lobe_reflectance(which, n, beyond, degrees), 4));
      rows.back().push_back(cell);
    }
  }
  return markdown(rows);
}

}  // namespace

std::vector<table> energy_tables() {
  std::string text =
      "# Directional-hemispherical reflectance R\n\nA lobe obeys the conservation of energy where R <= 1. "
      "Two readings "
      "of the lobe's angle: from the half vector to the normal, and from the outgoing ray to the mirror "
      "direction. "
      "Incidence in degrees. Negative lobes are set to zero. The last columns list the n in 1..1000 with R > "
      "1.\n\nLambert's k_d has R = pi k_d at every incidence. Phong's lobe is `blinn` with the angle to the "
      "mirror "
      "direction. Cook-Torrance follows the lobes; the angle-based lobe has [a page of its "
      "own](energy_angle.md).\n";
  for (const lobe_axis axis : kAxes) {
    text += "\n## " + heading(axis) + "\n\n";
    std::vector<std::vector<std::string>> rows{{"lobe", "R(1) at 0", "R(10) at 0", "R(100) at 0",
                                                "R(1000) at 0", "largest R at 0", "at 30", "at 60", "at 80",
                                                "R > 1 at 0", "R > 1 at 0, 30, 60 or 80"}};
    for (const auto& [which, name] : kLobes) {
      rows.push_back({std::string(name)});
      for (const int n : {1, 10, 100, 1000})
        rows.back().push_back(number(lobe_reflectance(which, n, axis, 0), 4));
      std::vector<bool> anywhere(kMaxExponent, false);
      std::vector<bool> normal(kMaxExponent, false);
      for (const double degrees : kIncidences) {
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
  text +=
      "\n## Beyond 90 degrees from the mirror direction\n\nOblique light leaves the surface beyond 90 "
      "degrees "
      "from its mirror direction too, where the lobe's cosine is negative. The table above has every lobe "
      "dark "
      "there, as Phong's max(0, R.V)^n is. That matters for a lobe that is not 0 at 90 degrees: "
      "`cosine-quadratic` below n = 2 and `lyon-K` below n = K. R for such lobes in three readings: dark; "
      "the "
      "cosine clipped to 0, as a device gets it; the formula at the negative cosine.\n\n" +
      beyond_table();
  text +=
      "\n## Cook-Torrance, R_s = F D G/(N.V), index 1.5\n\nAs [T] (1.4) has it, without the pi (N.L) of Cook "
      "and Torrance's "
      "own divisor; the Gaussian D lacks the 1/m^2 too. Nowhere above 1.\n\n" +
      cook_torrance_table();
  return {{"energy.md", text}};
}

namespace {

/// Exponents of the angle-based lobe's tables: each to 40, then in steps of a twentieth.
std::vector<int> sampled_exponents() {
  std::vector<int> result;
  for (int n = 1; n < kMaxExponent; n += std::max(1, n / 20)) result.push_back(n);
  result.push_back(kMaxExponent);
  return result;
}

/// R of the angle-based lobe without a factor, at each sampled exponent.
using by_incidence = std::array<std::vector<double>, kIncidences.size()>;

struct angle_energies {
  double q;
  int k;
  std::array<by_incidence, kAxes.size()> bare;
  std::vector<double> exact, fitted;  ///< coefficients; fitted is 0 for n <= k, where there is none
};

std::vector<angle_energies> measure_angle_energies(const std::vector<int>& exponents) {
  std::vector<angle_energies> result;
  for (const double q : kLevels) {
    for (int k = 1; k <= 5; ++k) {
      angle_energies row{q, k, {}, {}, {}};
      for (const int n : exponents) {
        for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
          for (std::size_t i = 0; i < kIncidences.size(); ++i)
            row.bare[axis][i].push_back(angle_reflectance(n, k, q, 1, kAxes[axis], kIncidences[i]));
        }
        row.exact.push_back(angle_coefficient_exact<double>(n, k, q));
        row.fitted.push_back(n > k ? angle_coefficient_fitted<double>(n, k, q) : 0);
      }
      result.push_back(std::move(row));
    }
  }
  return result;
}

/// "1..17, 25..1000" of sampled exponents: a range ends at the last sample inside.
std::string sampled_ranges(const std::vector<int>& exponents, const std::vector<bool>& members) {
  std::string result;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (!members[i]) continue;
    const std::size_t first = i;
    while (i + 1 < members.size() && members[i + 1]) ++i;
    append(result, ", ", std::to_string(exponents[first]));
    if (i > first) result += ".." + std::to_string(exponents[i]);
  }
  return result.empty() ? "none" : result;
}

}  // namespace

std::vector<table> angle_energy_tables() {
  const std::vector<int> exponents = sampled_exponents();
  const auto measured = measure_angle_energies(exponents);
  std::string text =
      "# Reflectance R of the angle-based lobe\n\nAs in [energy.md](energy.md), by Q and k: the lobe as it "
      "is, with the "
      "exact coef and with the fitted one, which begins at n = k + 1. Where n < k the lobe passes 90 "
      "degrees: R is "
      "clipped there, the exact coef is not, as [A] has it. Exponents: each to 40, then in steps of 5 %, so "
      "ranges with "
      "R > 1 end at the last such exponent inside. R above 1 by no more than 10^-9, the quadrature's error, "
      "counts as "
      "1.\n";
  const std::pair<std::string_view, std::function<double(const angle_energies&, std::size_t)>> kinds[] = {
      {"the lobe as it is", [](const angle_energies&, std::size_t) { return 1.0; }},
      {"exact coef", [](const angle_energies& row, std::size_t i) { return row.exact[i]; }},
      {"fitted coef", [](const angle_energies& row, std::size_t i) { return row.fitted[i]; }}};
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    for (const auto& [title, coefficient] : kinds) {
      text += "\n## " + heading(kAxes[axis]) + ": " + std::string(title) + "\n\n";
      std::vector<std::vector<std::string>> rows{{"Q", "k", "R(10) at 0", "R(1000) at 0", "largest R at 0",
                                                  "at 30", "at 60", "at 80", "R > 1 at 0",
                                                  "R > 1 at 0, 30, 60 or 80"}};
      for (const angle_energies& row : measured) {
        const auto r = [&, &factor = coefficient](std::size_t incidence, std::size_t i) {
          return factor(row, i) * row.bare[axis][incidence][i];
        };
        const auto position = [&](int n) {
          return static_cast<std::size_t>(std::ranges::find(exponents, n) - exponents.begin());
        };
        rows.push_back({number(row.q), std::to_string(row.k), number(r(0, position(10)), 4),
                        number(r(0, position(1000)), 4)});
        std::vector<bool> normal(exponents.size());
        std::vector<bool> anywhere(exponents.size());
        for (std::size_t incidence = 0; incidence < kIncidences.size(); ++incidence) {
          worst most{-1, 1};
          for (std::size_t i = 0; i < exponents.size(); ++i) {
            const double value = r(incidence, i);
            const bool above = value > 1 + 1e-9;
            anywhere[i] = anywhere[i] || above;
            if (incidence == 0) normal[i] = above;
            // Values that differ by rounding alone go to the first exponent.
            if (value > most.value * (1 + 1e-9)) most = {value, exponents[i]};
          }
          rows.back().push_back(at(most, 4));
        }
        rows.back().push_back(sampled_ranges(exponents, normal));
        rows.back().push_back(sampled_ranges(exponents, anywhere));
      }
      text += markdown(rows);
    }
  }
  return {{"energy_angle.md", text}};
}

namespace {

/// Power of ten that a loss reaches: further digits depend on the version of the mathematical library.
std::string at_least(double ulp) {
  if (!std::isfinite(ulp)) return "not finite";
  return ulp < 1 ? "< 1" : "10^" + std::to_string(static_cast<int>(std::log10(ulp)));
}

}  // namespace

std::vector<table> stability_tables() {
  std::vector<std::vector<std::string>> rows{{"literal form", "stable form", "of", "float: literal",
                                              "stable within", "double: literal", "stable within"}};
  for (const hard_form& form : hard_forms()) {
    const loss single = worst_of(form, form.in_float);
    const loss twice = worst_of(form, form.in_double);
    rows.push_back({form.literal, form.stable, form.argument, at_least(single.literal),
                    number(single.bound, 2), at_least(twice.literal), number(twice.bound, 2)});
  }
  std::vector<std::vector<std::string>> bits{{"n", "n 2^-(f+1) <= 1/510 asks for", "measured"}};
  for (const int n : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000}) {
    bits.push_back(
        {std::to_string(n), number(std::ceil(std::log2(n * 510.0) - 1)), std::to_string(cosine_bits(n))});
  }
  return {{"stability.md",
           "# Literal and stable forms: errors in ulp\n\nEach row goes through the points that its plot in "
           "[numerics.md](../numerics.md) shows and stands at the one where the literal form is furthest "
           "outside the "
           "stable form's bound: the literal error there, as the power of ten that it reaches, and the "
           "bound, which "
           "running error analysis gives for the stable form's own steps. The exact value is the stable form "
           "in 50 "
           "digits at the point as float or double holds it. An ulp is the spacing of the numbers at the "
           "exact value; "
           "2 roundoffs, each 2^-24 or 2^-53, make an ulp of 1. `ctest -R golden.stability` holds every "
           "stable form to "
           "its bound at every point and prints all digits.\n\n" +
               markdown(rows) +
               "\n## Fraction bits of the cosine\n\nThe slope of cos^n near cos = 1 is n: f fraction bits, "
               "rounded, "
               "move the result by n 2^-(f+1) at most. Measured: the cosines halfway between the codes are "
               "rounded "
               "either way, and half an 8-bit step is allowed.\n\n" +
               markdown(bits)}};
}

}  // namespace blysk::golden
