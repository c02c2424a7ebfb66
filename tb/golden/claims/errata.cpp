// SPDX-License-Identifier: Apache-2.0
// Where a seed contradicts itself or mathematics, what was decided, and what either side measures.
#include <cmath>
#include <stdexcept>

#include "tb/golden/angle.h"
#include "tb/golden/claims/claim.h"
#include "tb/golden/claims/sweep.h"
#include "tb/golden/registry.h"
#include "tb/golden/scene.h"
#include "tb/golden/shift_division.h"

namespace blysk::golden {
namespace {

std::string refusal(std::string_view name, std::vector<double> inputs) {
  try {
    find_model(name)->value(inputs);
  } catch (const std::domain_error& error) {
    return std::string("\"").append(error.what()).append("\"");
  }
  return "accepted";
}

std::string whole_errors(lobe which) {
  std::string result;
  for (const int n : {1, 2, 10, 100, 1000})
    append(result, ", ", number(errors_of(which)[static_cast<std::size_t>(n) - 1].whole.value));
  return result;
}

double fixed_point(std::string_view bits) {
  double result = 0;
  double weight = 1;
  for (const char bit : bits) result += (weight /= 2) * (bit == '1');
  return result;
}

std::string energy_at_all(lobe which) {
  double most = 0;
  for (int n = 1; n <= kMaxExponent; ++n) {
    for (const double degrees : {0.0, 30.0, 60.0, 80.0})
      most = std::max(most, lobe_reflectance(which, n, lobe_axis::half_vector, degrees));
  }
  return number(most, 5);
}

}  // namespace

std::vector<claim> errata() {
  std::vector<claim> rows;
  const std::string open = " Decision: ";
  rows.push_back({"E1", "[P] (10)", "a = 0.786 n + 0.5",
                  "largest absolute error, clamped, at n = 1, 2, 10, 100, 1000: published " +
                      whole_errors(lobe::quadratic_published) + "; derived (- 0.5) " +
                      whole_errors(lobe::quadratic_derived) + "; exact a " +
                      whole_errors(lobe::quadratic_exact) + "." + open +
                      "the derived line is the default, the others can be chosen",
                  verdict_of(false)});
  std::string bits;
  for (const std::string_view reading : {"11001001", "110010", "110011"})
    append(bits, ", ", "0.", reading, "b = ", number(fixed_point(reading), 8), " (",
           number(fixed_point(reading) - 0.786, 2), ")");
  rows.push_back({"E2", "[P] block 6", "bits 1, 2, 5, 6 of the constant are one, 3, 4, 6 zero",
                  "bit 6 is both. " + bits + ", difference to 0.786 in brackets." + open + "bits 1, 2, 5, 8",
                  verdict_of(false)});
  rows.push_back({"E3", "[P] adder 15",
                  "first bit of the constant: zero in the claim, one in the description",
                  "bit one gives 0.5, bit zero 0. With + 0 in place of + 0.5 a(1) is " + number(0.786) +
                      ", with + 0.5 " + number(coefficient(coefficient_line::published, 1.0)) + ", by (9) " +
                      number(exact_coefficient(1.0)) + "." + open + "the description",
                  verdict_of(false)});
  const auto lowest = [](lobe which) {
    return largest([&](double c) { return -evaluate(which, 1000.0, c); }, 1000, 0, 1);
  };
  rows.push_back(
      {"E4", "[P] (3)", "nothing limits the parabola",
       "its least value at n = 1000: published " + number(-lowest(lobe::quadratic_published).value, 5) +
           ", derived " + number(-lowest(lobe::quadratic_derived).value, 5) +
           ", at cos = " + number(lowest(lobe::quadratic_derived).cos, 4) + "." + open + "clamped to [0, 1]",
       verdict_of(false)});
  const double square_at_0 = std::pow(1 - 1001.0 / 3, 2);
  rows.push_back(
      {"E5", "[T] fig. 3.1", "a limit per n on the square tells the lobe from what lies beyond its root",
       "the square at cos = 0, n = 1000 is " + number(square_at_0, 6) +
           "; at one distance either side of the root it takes one value, so no limit separates them." +
           open + "gated by the sign of adder 8",
       verdict_of(false)});
  rows.push_back({"E6", "[T] fig. 3.1", "all ones subtract 1, a carry adds 1",
                  "with 15 fraction bits either is one LSB, " + number(std::ldexp(1.0, -15)) + ", not 1." +
                      open + "constants have the weight of unity",
                  verdict_of(false)});
  std::string readings;
  for (const auto& [name, which] : {std::pair{"A", lobe::schlick_modified_a},
                                    {"B", lobe::schlick_modified_b},
                                    {"C", lobe::schlick_modified_c},
                                    {"D", lobe::schlick_modified}}) {
    const worst w = worst_relative(which, epicentre::level_060);
    append(readings, ", ", name, " ", percent_at(w), " and ", percent(errors_of(which)[99].relative[0].value),
           " at n = 100");
  }
  rows.push_back(
      {"E7", "[T] (2.2)", "the added term is 0.5 n (1 - cos gamma^2)",
       "largest relative error where c^n >= 0.6: " + readings + "." + open + "D, the others by name",
       std::string(kAmbiguous) + ": four readings"});
  rows.push_back(
      {"E8", "[T] (2.26)", "(n + 6)/24.55 keeps R <= 1",
       "largest R, incidence 0, 30, 60, 80 degrees: " + energy_at_all(lobe::cosine_quadratic_energy) +
           "; with (n + 1)/(8 pi) " + energy_at_all(lobe::cosine_quadratic_energy_safe) +
           "; the safe quadratic " + energy_at_all(lobe::quadratic_energy_safe) +
           ". [By lobe](tables/energy.md)." + open + "published form kept, safe forms added",
       verdict_of(false)});
  const double q = 0.5;
  const double coefficient_100 = angle_coefficient_exact(100.0, 2.0, q);
  rows.push_back(
      {"E9", "[A] Int",
       "x is the polar angle of the outgoing ray, though the lobe's angle is that to the half vector",
       "exact coef, Q = 0.5, k = 2, n = 100: R = " +
           number(angle_reflectance(100, 2, q, coefficient_100, lobe_axis::mirror, 0), 4) +
           " as integrated, " +
           number(angle_reflectance(100, 2, q, coefficient_100, lobe_axis::half_vector, 0), 4) +
           " with the half vector. [By Q, k, n](tables/energy_angle.md)." + open + "both are reported",
       verdict_of(false)});
  rows.push_back({"E10", "[A] fitted coef", "covers Q in [0.1; 0.4] and [0.5; 0.9]",
                  "Q = 0.45: " + refusal("angle-coef-fitted", {10, 2, 0.45}) +
                      "; n = k: " + refusal("angle-coef-fitted", {2, 2, 0.5}) +
                      "; exact coef at Q = 0.45: " + number(angle_coefficient_exact(10.0, 2.0, 0.45), 5),
                  std::string(kAmbiguous) + ": nothing is said of the gap"});
  rows.push_back(
      {"E11", "[A] gran", "the integral runs to the lobe's zero",
       "gran at Q = 0.5, k = 5: n = 1 " + number(angle_limit(1.0, 5.0, q), 4) + ", n = 4 " +
           number(angle_limit(4.0, 5.0, q), 4) + ", n = 5 " + number(angle_limit(5.0, 5.0, q), 4) +
           " rad, so for n < k it passes pi/2; R of the exact coef clipped there, n = 1: " +
           number(angle_reflectance(1, 5, q, angle_coefficient_exact(1.0, 5.0, q), lobe_axis::mirror, 0), 4) +
           "." + open + "clipped in R, not in coef",
       verdict_of(false)});
  std::string thresholds;
  for (const epicentre where : kEpicentres)
    append(thresholds, "; ", name_of(where), ": level ", number(std::pow(epicentre_edge(where, 2), 2)),
           " at n = 2, ", number(std::pow(epicentre_edge(where, 1000), 1000)), " at n = 1000");
  rows.push_back({"E12", "\"epicentre\"", "used with three thresholds",
                  thresholds + "." + open + "all three are reported",
                  std::string(kAmbiguous) + ": not defined"});
  rows.push_back({"E13", "figures of accuracy", "3.2 %, 3 %, 2 %, 0.4 %, 10 times, 4 times, 8e-5, ...",
                  "rows T1, T2, T4..T6, T8..T12, T17..T19, T33..T36",
                  std::string(kAmbiguous) + ": several do not hold, row by row"});
  rows.push_back({"E14", "[T] 2.4", "1/k as shifts of 1/2 and less",
                  "k = 1 needs 2^0: in 8 places its digits are " + std::to_string(reciprocal_digits(1, 8)) +
                      ", one bit more than they hold; the figures hold for rounding to nearest (T24)." +
                      open + "k = 1 passes through",
                  verdict_of(false)});
  rows.push_back({"E15", "[P] misprints",
                  "input 15 and block 15; \"third adder 3\"; block 10 fed from \"ROM 6\"; (2) twice",
                  "misprints without a number to measure." + open + "the figure's netlist stands",
                  std::string(kUncheckable)});
  rows.push_back({"E16", "[T] interface", "n from 0",
                  refusal("quadratic-published", {0, 0.5}) + "; at n = 0 the published line gives a = " +
                      number(coefficient(coefficient_line::published, 0.0)) +
                      ", cos^0 is 1 and the quadratic at cos = 0.5 " +
                      number(quadratic(coefficient_line::published, 0.0, 0.5)) + "." + open + "n in 1..1000",
                  verdict_of(false)});
  const vec3<double> light = normalised(vec3<double>{0.4, 0.5, 0.75});
  const auto half_vec = half_vector(light, -1.0 * light);
  rows.push_back({"E17", "[P] (2)", "H = (L + V)/|L + V|",
                  "L + V = 0: literally 0/0; here N.H = " + number(clamped_cosine(light, half_vec)) + "." +
                      open + "no highlight, no NaN",
                  verdict_of(false)});
  return rows;
}

}  // namespace blysk::golden
