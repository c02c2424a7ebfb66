// SPDX-License-Identifier: Apache-2.0
// The errata one by one: what either side of each measures.
#include <array>
#include <cmath>

#include "tb/claims/measure/listing_triangle.h"
#include "tb/claims/measure/over_exponents.h"
#include "tb/claims/measure/patent_constants.h"
#include "tb/claims/tables/tables.h"
#include "tb/claims/words.h"
#include "tb/golden/angle.h"
#include "tb/golden/scene.h"
#include "tb/golden/shift_division.h"

namespace blysk::claims {

using namespace golden;
namespace {

using table_lines = std::vector<std::vector<std::string>>;

/// One row per entry of `points`: its name, then what `values` makes of it.
template <class Points, class Values>
std::string tabulate(std::vector<std::string> head, const Points& points, const Values& values) {
  table_lines rows{std::move(head)};
  for (const auto& point : points) rows.push_back(values(point));
  return markdown(rows);
}

constexpr std::array kFew{1, 2, 3, 10, 100, 1000};

std::string table_e1_e3_e4() {
  const auto lines = [](const auto& value, bool with_exact) {
    std::vector<std::string> head{"n", "published, + 0.5", "derived, - 0.5"};
    if (with_exact) head.emplace_back("exact, (9)");
    return tabulate(head, kFew, [&](int n) {
      std::vector<std::string> row{std::to_string(n)};
      for (const auto line :
           {coefficient_line::published, coefficient_line::derived, coefficient_line::exact}) {
        if (with_exact || line != coefficient_line::exact) row.push_back(number(value(line, n), 5));
      }
      return row;
    });
  };
  const auto a = [](coefficient_line line, int n) { return coefficient<double>(line, n); };
  return "\n## E1\n\na of the lines less that of (9)\n\n" +
         lines([&](coefficient_line line, int n) { return a(line, n) - a(coefficient_line::exact, n); },
               false) +
         "\n## E2\n\n" +
         tabulate({"bits", "value", "less 0.786", "at n = 1000, in a"}, kConstants,
                  [](std::string_view bits) {
                    const double value = fixed_point(bits);
                    return std::vector<std::string>{"0." + std::string(bits), number(value, 8),
                                                    number(value - 0.786, 3),
                                                    number(1000 * (value - 0.786), 3)};
                  }) +
         "\n## E3\n\na with the first bit of adder 15's constant\n\n" +
         tabulate({"n", "zero", "one", "(9)"}, kFew,
                  [](int n) {
                    return std::vector<std::string>{std::to_string(n), number(0.786 * n, 6),
                                                    number(0.786 * n + 0.5, 6),
                                                    number(exact_coefficient<double>(n), 6)};
                  }) +
         "\n## E4\n\nLeast value of the parabola, -(a - 1)^2 / (4a) where a > 1\n\n" +
         lines(
             [&](coefficient_line line, int n) {
               const double value = a(line, n);
               return value > 1 ? -(value - 1) * (value - 1) / (4 * value) : 0;
             },
             true);
}

std::string table_e5_e6() {
  return "\n## E5\n\nEither side of the root, the distance as a share of that from root to peak, n = "
         "100\n\n" +
         tabulate({"distance", "adder 8's sum inside", "its square", "adder 8's sum beyond", "its square"},
                  std::array{0.1, 0.25, 0.5, 1.0, 2.0},
                  [](double share) {
                    const double root = 1 - 3.0 / 101;
                    const auto sum = [](double c) { return 101 / 3.0 * (c - 1) + 1; };
                    const double inside = sum(root + share * (1 - root));
                    const double beyond = sum(root - share * (1 - root));
                    const bool on_the_lobe = share <= 1;
                    return std::vector<std::string>{number(share), on_the_lobe ? number(inside) : "-",
                                                    on_the_lobe ? number(inside * inside) : "-",
                                                    number(beyond), number(beyond * beyond)};
                  }) +
         "\n## E6\n\nWhat all ones add to cos = 0.75, as an integer of so many fraction bits\n\n" +
         tabulate({"fraction bits", "the sum", "cos - 1"}, std::array{0, 8, 12, 15, 24}, [](int bits) {
           return std::vector<std::string>{
               std::to_string(bits), bits == 0 ? "no fraction" : number(0.75 - std::ldexp(1.0, -bits), 8),
               number(-0.25)};
         });
}

std::string table_e7_e8() {
  table_lines rows{{"n", "A", "B", "C", "D"}};
  for (const int n : kFew) {
    rows.push_back({std::to_string(n)});
    for (const lobe which : {lobe::schlick_modified_a, lobe::schlick_modified_b, lobe::schlick_modified_c,
                             lobe::schlick_modified})
      rows.back().push_back(percent(errors_of(which)[static_cast<std::size_t>(n) - 1].relative[0].value));
  }
  const auto r = [](lobe which, int n) {
    return number(lobe_reflectance(which, n, lobe_axis::half_vector, 0), 4);
  };
  return "\n## E7\n\nLargest relative error where c^n >= 0.6, by reading\n\n" + markdown(rows) +
         "\n## E8\n\nR at normal incidence; [by lobe](energy.md)\n\n" +
         tabulate({"n", "(n + 6)/24.55", "(n + 1)/(8 pi)", "safe quadratic"}, std::array{1, 7, 17, 100, 1000},
                  [&](int n) {
                    return std::vector<std::string>{std::to_string(n), r(lobe::cosine_quadratic_energy, n),
                                                    r(lobe::cosine_quadratic_energy_safe, n),
                                                    r(lobe::quadratic_energy_safe, n)};
                  });
}

std::string table_e9_e10_e11() {
  const double q = 0.5;
  const auto gap = [](double n, double k) {
    std::vector<std::string> row{number(n, 4), number(k)};
    for (const double level : {0.4, 0.45, 0.5})
      row.push_back(number(angle_coefficient_exact(n, k, level), 5));
    for (const double level : {0.4, 0.5}) row.push_back(number(angle_coefficient_fitted(n, k, level), 5));
    return row;
  };
  table_lines limits{{"k \\ n", "1", "2", "4", "5", "10", "100", "1000"}};
  for (const int k : {1, 2, 5}) {
    limits.push_back({std::to_string(k)});
    for (const int n : {1, 2, 4, 5, 10, 100, 1000})
      limits.back().push_back(
          number(angle_limit<double>(n, k, q) * 2 / boost::math::constants::pi<double>(), 4));
  }
  return "\n## E9\n\nR of the exact coef at normal incidence, Q = 0.5, k = 2\n\n" +
         tabulate({"n", "x from the mirror direction", "x from the half vector"},
                  std::array{2, 10, 100, 1000},
                  [&](int n) {
                    const double coefficient = angle_coefficient_exact<double>(n, 2, q);
                    return std::vector<std::string>{
                        std::to_string(n),
                        number(angle_reflectance(n, 2, q, coefficient, lobe_axis::mirror, 0), 4),
                        number(angle_reflectance(n, 2, q, coefficient, lobe_axis::half_vector, 0), 4)};
                  }) +
         "\n## E10\n\nEither side of the gap and in it\n\n" +
         markdown({{"n", "k", "exact, Q = 0.4", "0.45", "0.5", "fitted, Q = 0.4", "0.5"},
                   gap(10, 1),
                   gap(10, 5),
                   gap(1000, 1),
                   gap(1000, 5)}) +
         "\n## E11\n\ngran at Q = 0.5 in right angles: above 1 it leaves the hemisphere\n\n" +
         markdown(limits);
}

std::string table_e12_to_e17() {
  const double pi = boost::math::constants::pi<double>();
  return "\n## E12\n\nWhere the epicentre ends, in degrees from the axis\n\n" +
         tabulate({"n", "c^n >= 0.6", "c^n >= 0.56", "up to the inflection point", "cos^n there"}, kFew,
                  [&](int n) {
                    std::vector<std::string> row{std::to_string(n)};
                    for (const epicentre where : kEpicentres)
                      row.push_back(number(angle_of_cosine(epicentre_edge(where, n)) * 180 / pi, 4));
                    row.push_back(number(std::pow(epicentre_edge(epicentre::inflection, n), n), 4));
                    return row;
                  }) +
         "\n## E13\n\n[Errors by lobe and exponent](errors.md), [NMSE](nmse.md).\n"
         "\n## E14\n\n8 shifts, difference 255\n\n" +
         tabulate({"k", "digits", "quotient", "by shifts"}, std::array{1u, 2u, 3u, 5u, 7u, 16u},
                  [](uint32_t k) {
                    return std::vector<std::string>{
                        std::to_string(k), std::to_string(reciprocal_digits(k, 8)), number(255.0 / k, 6),
                        number(shifted_quotient(255, k, 8), 6)};
                  }) +
         "\n## E15\n\n" +
         markdown({{"printed", "meant"},
                   {"control input 15 of register 1, and adder 15", "two things under one number"},
                   {"output of the third adder 3", "of adder 15; 3 is a register"},
                   {"a from read-only memory 6", "from adder 15; 6 is a multiplier"},
                   {"(2) for H and again for I", "the second is (1)"}}) +
         "\n## E16\n\nn = 0, where cos^0 is 1\n\n" +
         tabulate({"cos", "published", "derived"}, std::array{0.0, 0.5, 1.0},
                  [](double c) {
                    return std::vector<std::string>{number(c),
                                                    number(quadratic(coefficient_line::published, 0.0, c)),
                                                    number(quadratic(coefficient_line::derived, 0.0, c))};
                  }) +
         "\n## E17\n\nN along L, V so many degrees short of opposite to L\n\n" +
         tabulate({"short by", "length of L + V", "N . H"}, std::array{90.0, 1.0, 0.001, 0.0},
                  [&](double degrees) {
                    const vec3<double> light{0, 0, 1};
                    const double angle = degrees * pi / 180;
                    const vec3<double> view{std::sin(angle), 0, -std::cos(angle)};
                    const vec3<double> sum = light + view;
                    return std::vector<std::string>{
                        number(degrees), number(std::sqrt(dot(sum, sum)), 4),
                        number(clamped_cosine(light, half_vector(light, view)), 4)};
                  });
}

std::string table_e19_e20() {
  const quadratic_surface<double> right = surface_through(kTriangle, kIntensities);
  const auto& [i1, i2, i3, i12, i13, i23] = kIntensities;
  const six_intensities<double> means{i1, i2, i3, (i1 + i2) / 2, (i1 + i3) / 2, (i2 + i3) / 2};
  const listing_slips red{.term = true, .division = true, .blue = false};
  const listing_slips blue{.term = true, .division = true, .blue = true};
  return "\n## E19\n\nVertices (0, 0), (8, 4), (4, 8). Lines 322, 341 and 360 have 4 C12 - C23 Y2 in P4 "
         "where lines "
         "323, 342 and 361 have 4 C12 Y3 - C23 Y2 in P5; lines 327, 346 and 365 divide by Y2 and multiply by "
         "it; line "
         "358 has - 4 I23 where lines 316 and 339 have + 4 I23. P1 and P2 go with y and x as they are "
         "computed, so "
         "nothing is exchanged there. Besides, the first vertex has to be the origin and the coordinates are "
         "those of "
         "the picture; lines 501 to 512 put 100 or 255 in place of the colours\n\n" +
         tabulate({"at", "x", "y", "intensity", "the polynomial", "4 C12 without Y3", "/Y2*Y2", "- 4 I23",
                   "red as printed", "blue as printed"},
                  kNodes,
                  [&](const node& each) {
                    const auto with = [&](const listing_slips& slips) {
                      return number(surface_of_listing(kTriangle, kIntensities, slips).at(each.x, each.y), 6);
                    };
                    return std::vector<std::string>{each.name,
                                                    number(each.x),
                                                    number(each.y),
                                                    number(kIntensities.*each.intensity),
                                                    number(right.at(each.x, each.y), 6),
                                                    with({.term = true}),
                                                    with({.division = true}),
                                                    with({.blue = true}),
                                                    with(red),
                                                    with(blue)};
                  }) +
         "\n## E20\n\nThe same triangle: the polynomial with the intensities of the middles, and with the "
         "means of the "
         "vertices, as lines 309 to 311 have them, which is Gouraud's plane\n\n" +
         tabulate({"at", "intensity", "with the middles", "with the means"}, kNodes, [&](const node& each) {
           return std::vector<std::string>{each.name, number(kIntensities.*each.intensity),
                                           number(right.at(each.x, each.y), 6),
                                           number(surface_through(kTriangle, means).at(each.x, each.y), 6)};
         });
}

}  // namespace

std::vector<table> errata_tables() {
  return {{"errata.md",
           "# Errata, each with its numbers\n\nThe rows of [verification.md](../verification.md) say "
           "what the seed prints and what was decided.\n" +
               table_e1_e3_e4() + table_e5_e6() + table_e7_e8() + table_e9_e10_e11() + table_e12_to_e17() +
               table_e19_e20()}};
}

}  // namespace blysk::claims
