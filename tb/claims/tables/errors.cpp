// SPDX-License-Identifier: Apache-2.0
// docs/tables/errors.md: errors by lobe and exponent.
#include <algorithm>
#include <cmath>

#include "tb/claims/figure.h"
#include "tb/claims/slopes.h"
#include "tb/claims/sweep.h"
#include "tb/claims/tables/tables.h"
#include "tb/claims/words.h"

namespace blysk::claims {

using namespace golden;
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

}  // namespace blysk::claims
