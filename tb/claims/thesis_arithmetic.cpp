// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/thesis_arithmetic.h"

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "tb/golden/shift_division.h"

namespace blysk::golden {
namespace {

struct lattice_point {
  int x, y;
};

using lattice_triangle = std::array<lattice_point, 3>;

struct lattice_count {
  int inside = 0;
  int on_edge = 0;     ///< corners included
  int widest_row = 0;  ///< points of a row, edges included
};

/// Looks at every point of a square that holds the triangle.
lattice_count points_inside(const lattice_triangle& triangle) {
  constexpr int kReach = 32;
  lattice_count result;
  for (int y = -kReach; y <= kReach; ++y) {
    int row = 0;
    for (int x = -kReach; x <= kReach; ++x) {
      std::array<int, 3> sides{};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& a = triangle[i];
        const auto& b = triangle[(i + 1) % 3];
        sides[i] = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
      }
      const auto [least, most] = std::ranges::minmax(sides);
      if (least < 0 && most > 0) continue;
      ++row;
      ++(least == 0 || most == 0 ? result.on_edge : result.inside);
    }
    result.widest_row = std::max(result.widest_row, row);
  }
  return result;
}

/// How many pixels of a row are traced, if every segment has `inner` pixels between its ends; the last may be shorter.
int traced_pixels(int row, int inner) {
  int traced = 1;  // the row's first pixel
  for (int x = 0; x < row - 1; x = std::min(x + inner + 1, row - 1)) ++traced;
  return traced;
}

claim segment_tracing() {
  constexpr int kRows = 2048;
  constexpr int kInner = 64;
  int exact = 0;
  int one_more = 0;
  int rows = 0;
  int most = 0;  // elements by (2.31), rows that whole segments fill
  for (int inner = 1; inner <= kInner; ++inner) {
    for (int row = 2; row <= kRows; ++row, ++rows) {
      const int by_2_28 = static_cast<int>(std::ceil(static_cast<double>(row) / (inner + 1) + 1));
      const int traced = traced_pixels(row, inner);
      exact += by_2_28 == traced;
      one_more += by_2_28 == traced + 1;
      if ((row - 1) % (inner + 1) != 0) continue;
      const int segments = (row - 1) / (inner + 1);
      for (const int sum : {segments * inner + 1, segments * (inner + 1)})
        most = std::max(most, static_cast<int>(std::ceil(static_cast<double>(row) / sum)) + 1);
    }
  }
  return {
      "T39", "2.6, (2.28) to (2.31)",
      "so many processing elements trace a row; K = 2.3 decides between interpolation and tracing",
      "rows of 2.." + std::to_string(kRows) + " pixels, 1.." + std::to_string(kInner) +
          " inside a segment, pixels counted that are traced: (2.28) is exact for " +
          percent(static_cast<double>(exact) / rows) + " of them and one too many for " +
          percent(static_cast<double>(one_more) / rows) + "; (2.31) never exceeds " + std::to_string(most) +
          " where whole segments fill the row, with the 1 inside or outside its sum, however many they are. "
          "Between which colours K is a distance, and in which unit, is not said",
      verdict_of_parts(
          {{"(2.28) to within one", exact + one_more == rows}, {"(2.31)", most == traced_pixels(kRows, 1)}})};
}

void add_chapter_4(std::vector<claim>& rows) {
  const double pi = boost::math::constants::pi<double>();
  const double per_metre = 60 / (2 * pi * 3);  // soil 60 Ohm m, electrode of 3 m
  const double electrode = per_metre * (std::log(2 * 3 / 0.03) + std::log((4.0 * 1 + 3) / (4.0 * 1 - 3)) / 2);
  rows.push_back({"T48", "4.3.3, (4.2)", "an earth electrode has 19.96 Ohm", number(electrode, 4) + " Ohm",
                  verdict_of(rounds_to(electrode, 19.96, 2))});
  const double strip = per_metre * std::log(2 * 50.0 * 50.0 / (0.03 * 0.5));
  const double long_strip = strip * 3 / 50;
  rows.push_back({"T49", "4.3.3, (4.3)", "the strip that joins the electrodes has 14.37 Ohm",
                  "the numbers printed in it give " + number(strip, 4) +
                      " Ohm; with the strip's own length of 50 m in place of the electrode's " +
                      number(long_strip, 4),
                  verdict_of(std::vector<reading>{{"as printed", rounds_to(strip, 14.37, 2)},
                                                  {"with 50 m", rounds_to(long_strip, 14.37, 2)}})});
  const double electrodes = 2 * 19.9 / (4 * 0.5);
  const auto circuit = [&](double of_strip) {
    return 19.96 * of_strip / (of_strip * 20 * 0.5 + 19.96 * 0.4);
  };
  rows.push_back({"T50", "4.3.3, (4.1) (4.4)", "19.9, so 20 electrodes; all together 1.89 Ohm, below 4",
                  number(electrodes, 4) + " and " + number(circuit(14.37), 4) +
                      " Ohm from the printed numbers; " + number(circuit(strip), 4) +
                      " with the strip of T49 as printed",
                  verdict_of(rounds_to(electrodes, 19.9, 1) && rounds_to(circuit(14.37), 1.89, 2))});
  const double lamps = 300 * 16 * 1.1 * 1.5 / (5400 * 0.575 * 2);
  rows.push_back(
      {"T51", "4.4.2, (4.5) (4.6)",
       "windows of 2 m2 for 16 m2 of floor; 1.3 luminaires of two lamps of 80 W: one of 130 W will do",
       number(16.0 / 8) + " m2 by 1/8, and " + number(lamps, 4) + " luminaires; one gives " +
           percent(1 / lamps) + " of the light asked for, and two lamps of 80 W are 160 W",
       verdict_of_parts(std::vector<reading>{{"2 m2", rounds_to(16.0 / 8, 2, 0)},
                                             {"1.3", rounds_to(lamps, 1.3, 1)},
                                             {"one will do", lamps <= 1}})});
}

}  // namespace

void add_gouraud(std::vector<claim>& rows) {
  const double exact = 255.0 / 7;
  const double shifted = shifted_quotient(255, 7, 6);
  rows.push_back({"T22", "2.4", "(255 - 0)/7 = 36.4286, with 1/8 + 1/64 35.8594",
                  number(exact, 6) + " and " + number(shifted, 6) + "; digits of 1/7 in 6 places: 2^-6 * " +
                      std::to_string(reciprocal_digits(7, 6)),
                  verdict_of(rounds_to(exact, 36.4286, 4) && rounds_to(shifted, 35.8594, 4))});
  rows.push_back({"T23", "2.4",
                  "its absolute error is 0.5692 (0.5693 in the next formula), its relative one 1.56 %",
                  number(exact - shifted, 4) + " and " + percent((exact - shifted) / exact),
                  verdict_of(rounds_to(exact - shifted, 0.5692, 4) &&
                             rounds_to(100 * (exact - shifted) / exact, 1.56, 2))});
  const auto errors = [](int first, int steps) {
    double largest_error = 0;
    double mean = 0;
    for (int k = first; k <= 16; ++k) {
      const double error = std::abs(255.0 / k - shifted_quotient(255, static_cast<uint32_t>(k), steps));
      largest_error = std::max(largest_error, error);
      mean += error * k / 255 / (17 - first);
    }
    return std::pair{largest_error, mean};
  };
  const auto [largest_error, mean] = errors(2, 8);
  rows.push_back({"T24", "2.4",
                  "with 8 shifts the largest absolute error is 0.4427 and the mean relative one 0.81 %",
                  "digits rounded to nearest, k = 2..16, difference 255: " + number(largest_error, 4) +
                      " and " + percent(mean) + "; k = 3..16: " + percent(errors(3, 8).second),
                  verdict_of(rounds_to(largest_error, 0.4427, 4) && rounds_to(100 * mean, 0.81, 2))});
  std::string by_steps;
  for (const int steps : {6, 7, 8}) {
    double largest_relative = 0;
    for (uint32_t k = 2; k <= 16; ++k)
      largest_relative = std::max(largest_relative, std::abs(shifted_quotient(1, k, steps) * k - 1));
    append(by_steps, "; ", std::to_string(steps), " shifts: ", percent(largest_relative), " and ",
           percent(errors(2, steps).second));
  }
  rows.push_back(
      {"T46", "fig. 2.12", "relative errors for 6, 7 and 8 shifts",
       "k = 2..16, largest and mean: " + by_steps +
           ". [Picture](figures/thesis_fig2_12.svg). The seed's text keeps no number of its curves "
           "but those of T23 and T24",
       std::string(kUncheckable)});
  const int sums = 18 + 99 + 66 + 225;
  const int divisions = 9 + 33;
  const int edge_points = 3 * ((std::max(7, 8) - 1) + (std::max(9, 12) - 1) + (std::max(16, 4) - 1));
  rows.push_back({"T25", "table 2.1",
                  "408 additions and 42 divisions in all; 9, 18 for three edges in three colours, 99 on the "
                  "edges, 33 and 66 for the rows",
                  "the columns add up to " + std::to_string(sums) + " and " + std::to_string(divisions) +
                      "; 3 edges by 3 colours: 9 divisions of 2 subtractions; points inside the edges, 3 (7 "
                      "+ 11 + 15) = " +
                      std::to_string(edge_points) +
                      "; 11 inner rows by 3 colours: 33 divisions, 66 subtractions",
                  verdict_of(sums == 408 && divisions == 42 && edge_points == 99)});
  constexpr lattice_triangle kExample{lattice_point{0, 0}, lattice_point{7, 8}, lattice_point{-9, 12}};
  const auto count = points_inside(kExample);
  rows.push_back(
      {"T26", "table 2.1", "225 additions for the points of the rows",
       "the differences fix the triangle but for reflections: (0, 0), (7, 8), (-9, 12). With corners "
       "at pixel centres " +
           std::to_string(count.inside) + " points lie inside it, by 3 colours " +
           std::to_string(3 * count.inside) + "; " + std::to_string(count.on_edge) +
           " more lie on its edges (the text speaks of 100 points)",
       verdict_of(3 * count.inside == 225)});
  rows.push_back({"T41", "2.4", "a row of an average triangle of 100 pixels has at most 16 pixels",
                  "no distribution of triangles is given; the widest row of the worked triangle has " +
                      std::to_string(count.widest_row) + " pixels; the device's tables cover k = 2..16",
                  std::string(kUncheckable)});
  std::vector<std::string> prices;
  for (const int cycles : {2946, 2064}) {
    prices.emplace_back();
    for (int addition = 1; addition * sums < cycles; ++addition) {
      const int rest = cycles - addition * sums;
      if (rest % divisions == 0)
        append(prices.back(), " or ", std::to_string(addition), " and ", std::to_string(rest / divisions));
    }
  }
  rows.push_back({"T27", "2.4", "2946 cycles of a Pentium M against 2064: 1.43 times as fast",
                  "2946/2064 = " + number(2946.0 / 2064, 4) + ". Whole numbers of cycles for each of the " +
                      std::to_string(sums) + " sums and each of the " + std::to_string(divisions) +
                      " divisions that give 2946: " + prices[0] +
                      ", nothing else; that give 2064: " + prices[1] +
                      ", nothing else, so the figures agree with one another: a sum costs the same in both. "
                      "Whether they are that processor's takes the processor",
                  verdict_of_parts(std::vector<reading>{
                      {"the quotient", rounds_to(2946.0 / 2064, 1.43, 2)},
                      {"table 2.1 and both totals agree", prices[0] == "3 and 41" && prices[1] == "3 and 20"},
                      {"the cycles", false}})});
}

void add_devices(std::vector<claim>& rows) {
  rows.push_back(segment_tracing());
  const std::vector<std::pair<std::string, std::vector<std::string>>> blocks{
      {"read-only memory", {"9", "33"}},
      {"adder", {"6", "8"}},
      {"register", {"1", "2", "3", "4", "5"}},
      {"multiplier", {"7", "10", "one for R", "one for G", "one for B"}},
      {"comparator", {"11"}},
      {"key block", {"12"}}};
  std::string text;
  std::vector<std::size_t> counted;
  for (const auto& [kind, numbers] : blocks) {
    std::string list;
    for (const auto& name : numbers) append(list, ", ", name);
    append(text, "; ", kind, " ", list, " (", std::to_string(numbers.size()), ")");
    counted.push_back(numbers.size());
  }
  rows.push_back(
      {"T40", "3.1",
       "the device takes two read-only memories, two adders, five registers, five multipliers, a "
       "comparator and a key block",
       "blocks that the section's account of the data names, and what registers 3 to 5 feed: " + text,
       verdict_of(counted == std::vector<std::size_t>{2, 2, 5, 5, 1, 1})});
  bool all_ones_subtract = true;
  constexpr unsigned kMask = 0xffff;
  for (unsigned x = 0; x <= kMask; ++x)
    all_ones_subtract = all_ones_subtract && ((x + kMask) & kMask) == ((x - 1) & kMask);
  rows.push_back({"T47", "3.1", "the code 111...11 is the two's complement of 1, so adding it subtracts 1",
                  std::string(all_ones_subtract ? "it does" : "it does not") +
                      " for every whole number of 16 bits. 1 is one unit of the last place: see E6",
                  verdict_of(all_ones_subtract)});
  add_chapter_4(rows);
}

}  // namespace blysk::golden
