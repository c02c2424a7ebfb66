// SPDX-License-Identifier: Apache-2.0
// docs/tables/energy.md and energy_angle.md: reflectance.
#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <functional>

#include "tb/claims/article.h"
#include "tb/claims/sweep.h"
#include "tb/claims/tables/tables.h"
#include "tb/claims/words.h"
#include "tb/golden/angle.h"
#include "tb/golden/scene.h"

namespace blysk::claims {

using namespace golden;
namespace {

constexpr std::array kIncidences{0.0, 30.0, 60.0, 80.0};  // degrees
constexpr std::array kAxes{lobe_axis::half_vector, lobe_axis::mirror};

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

}  // namespace blysk::claims
