// SPDX-License-Identifier: Apache-2.0
// [T]: the thesis.
#include <algorithm>
#include <cmath>
#include <functional>

#include "tb/golden/claims/claim.h"
#include "tb/golden/claims/pictures.h"
#include "tb/golden/claims/speed.h"
#include "tb/golden/claims/sweep.h"
#include "tb/golden/shift_division.h"

namespace blysk::golden {
namespace {

/// "3.2 % or less in the highlight": largest relative error of each lobe in each epicentre, against one
/// limit.
struct relative_claim {
  std::string id, place, says;
  std::vector<std::pair<std::string, lobe>> lobes;
  double limit;
  int last = kMaxExponent;
};

claim measured_against(const relative_claim& c) {
  std::string text;
  std::vector<reading> readings;
  for (const auto& [name, which] : c.lobes) {
    append(text, "; ", name, ": ");
    std::string separator;
    for (const epicentre where : kEpicentres) {
      const worst w = worst_relative(which, where, c.last);
      text += separator + std::string(name_of(where)) + " " + percent_at(w);
      separator = ", ";
      readings.push_back({name + " (" + std::string(name_of(where)) + ")", w.value <= c.limit});
    }
  }
  return {c.id, c.place, c.says, text, verdict_of(readings)};
}

/// Errors of Schlick's lobe over those of another, worst over n against worst over n, by epicentre.
claim ratio_claim(std::string id, std::string place, std::string says, lobe better, double factor,
                  bool relative) {
  std::string text;
  std::vector<reading> readings;
  for (const epicentre where : kEpicentres) {
    const auto measure = [&](lobe which) {
      return relative ? worst_relative(which, where).value : worst_absolute(which, where).value;
    };
    const double ratio = measure(lobe::schlick) / measure(better);
    append(text, ", ", name_of(where), " ", number(ratio), " times");
    readings.push_back({std::string(name_of(where)), ratio >= factor});
  }
  if (!relative) {
    const double ratio = worst_whole(lobe::schlick).value / worst_whole(better).value;
    append(text, ", ", "over the whole range ", number(ratio), " times");
    readings.push_back({"the whole range", ratio >= factor});
  }
  return {std::move(id), std::move(place), std::move(says),
          "largest errors over n = 1..1000, Schlick's over the other's: " + text, verdict_of(readings)};
}

/// R of the cosine-quadratic at normal incidence as [T] (2.25) integrates: theta to `limit`, second lobe
/// included.
double published_integral(double n, double limit) {
  const auto integrand = [n](double theta) {
    const double w = (n + 1) / 3 * (std::cos(theta / 2) - 1) + 1;
    return w * w * std::cos(theta) * std::sin(theta);
  };
  return boost::math::constants::two_pi<double>() *
         boost::math::quadrature::gauss_kronrod<double, 61>::integrate(integrand, 0.0, limit, 10, 1e-12);
}

std::string excess(const std::function<double(int)>& reflectance_of) {
  std::vector<bool> members;
  for (int n = 1; n <= kMaxExponent; ++n) members.push_back(reflectance_of(n) > 1);
  return ranges(members);
}

const std::vector<std::pair<std::string, lobe>> kModified{{"reading A", lobe::schlick_modified_a},
                                                          {"reading B", lobe::schlick_modified_b},
                                                          {"reading C", lobe::schlick_modified_c},
                                                          {"reading D", lobe::schlick_modified}};
const std::vector<std::pair<std::string, lobe>> kQuadratics{{"exact a", lobe::quadratic_exact},
                                                            {"published line", lobe::quadratic_published},
                                                            {"derived line", lobe::quadratic_derived}};
const std::vector<std::pair<std::string, lobe>> kCosineQuadratic{
    {"cosine-quadratic", lobe::cosine_quadratic}};

void add_schlick(std::vector<claim>& rows) {
  rows.push_back(measured_against({"T1",
                                   "2.1",
                                   "Schlick's largest relative error is not more than 3.2 %",
                                   {{"Schlick", lobe::schlick}},
                                   0.032}));
  rows.push_back(measured_against({"T2",
                                   "2.7, 3.4, conclusions",
                                   "Schlick's largest relative error in the highlight is 10 %",
                                   {{"Schlick", lobe::schlick}},
                                   0.10}));
  const auto rises = worst_over(1, kMaxExponent, [](int n) {
    double result = -1;
    for (int i = 0; i < 256; ++i)
      result = std::max(result, schlick<double>(n, i / 256.0) - schlick<double>(n, (i + 1) / 256.0));
    return result;
  });
  rows.push_back(
      {"T3", "2.1", "Schlick's function falls monotonically with the angle",
       "largest step against it over 256 steps of the cosine, n = 1..1000: " + number(rises.value, 2),
       verdict_of(rises.value < 0)});
  rows.push_back(measured_against(
      {"T4", "2.7, conclusions",
       "the modified Schlick's largest relative error in the highlight is not more than 3.2 %", kModified,
       0.032}));
  rows.push_back(measured_against(
      {"T5", "3.4", "the modified Schlick's largest relative error in the highlight is not more than 0.4 %",
       kModified, 0.004}));
  std::string text;
  std::vector<reading> readings;
  for (const auto& [name, which] : kModified) {
    for (const epicentre where : kEpicentres) {
      const double difference =
          worst_relative(lobe::schlick, where).value - worst_relative(which, where).value;
      append(text, "; ", name, ", ", name_of(where), ": ", percent(difference));
      readings.push_back(
          {name + " (" + std::string(name_of(where)) + ")", rounds_to(100 * difference, 6.8, 1)});
    }
  }
  rows.push_back({"T6", "2.1", "the modification's largest relative error differs from Schlick's by 6.8 %",
                  "difference in percentage points: " + text, verdict_of(readings)});
  rows.push_back({"T7", "table 3.2", "the modified Schlick as cos^a x / (n - n cos x + cos x)",
                  "a is nowhere given; (2.2) prints another form", std::string(kUncheckable)});
}

void add_quadratic(std::vector<claim>& rows) {
  rows.push_back(
      measured_against({"T8", "2.2", "the quadratic's relative error is not more than 3 % in the epicentre",
                        kQuadratics, 0.03}));
  const double tail =
      largest_relative_error(clamped_lobe(lobe::quadratic_exact, 100), 100, std::pow(0.1, 0.01)).value;
  rows.push_back({"T9", "2.2", "and not more than 3 % in the attenuation zone too",
                  "exact a, n = 100, down to cos^n = 0.1: " + percent(tail) + "; the lobe ends at cos^n = " +
                      number(std::pow(root_cosine(lobe::quadratic_exact, 100), 100)) +
                      ", from where on it is 100 %",
                  verdict_of(tail <= 0.03)});
  rows.push_back(measured_against(
      {"T10", "conclusions", "the quadratic keeps the epicentre within 2 %", kQuadratics, 0.02}));
  rows.push_back(measured_against(
      {"T11", "fig. 2.7", "level 0.56 and above, n in [1; 512]: the largest relative error is 3 % (2.2)",
       kQuadratics, 0.03, 512}));
  rows.push_back(ratio_claim("T12", "3.4",
                             "the quadratic is more than 10 times as exact in the epicentre (as Schlick's)",
                             lobe::quadratic_exact, 10, true));
  const auto& e = errors_of(lobe::quadratic_exact);
  const auto share = worst_over(3, kMaxExponent, [&](int n) {
    const auto& s = e[static_cast<std::size_t>(n) - 1];
    return -s.rms / s.whole.value;
  });
  rows.push_back(
      {"T13", "introduction", "the quadratic spreads its absolute error evenly over the whole interval",
       "rms over largest absolute error over cos in [0, 1], which evenness would make 1: at least " +
           number(-share.value) + " (n = " + std::to_string(share.n) + "), " +
           number(e[99].rms / e[99].whole.value) + " at n = 100",
       std::string(kAmbiguous) + ": evenness is not defined"});
}

void add_cosine_quadratic(std::vector<claim>& rows) {
  const auto area = worst_over(2, kMaxExponent, [](int n) {
    const auto lobe_area = [n](double c) { return cosine_quadratic(1.0 * n, c); };
    const double integral =
        boost::math::quadrature::gauss_kronrod<double, 31>::integrate(lobe_area, 1 - 3.0 / (n + 1), 1.0);
    return std::abs(integral * (n + 1) - 1) / n;  // the root's rounding is n times that of the lobe's width
  });
  rows.push_back(
      {"T14", "(2.13) (2.14)", "both lobes enclose 1/(n + 1), hence sigma = (n + 1)/3",
       "largest relative difference over n = 2..1000: " + number(area.value, 2) + " n" +
           ". At n = 1 the root lies beyond 90 degrees, and the area is " + number(26.0 / 54) +
           " in place of 0.5",
       verdict_of_parts(std::vector<reading>{{"n in 2..1000", area.value < kRounding}, {"n = 1", false}})});
  // The point where the relative error is stationary, c = n / (n + 1), and its level.
  const auto stationary = worst_over(1, kMaxExponent, [](int n) {
    return std::abs(std::cos(std::atan(std::sqrt(1 + 2.0 * n) / n)) - n / (n + 1.0));
  });
  const double level_low = std::pow(1000.0 / 1001, 1000);
  rows.push_back({"T15", "2.3",
                  "the relative error is largest at gamma = arctg(sqrt(1 + 2n)/n), at the level 0.2..0.4",
                  "cos of that angle is n/(n + 1) (to " + number(stationary.value, 2) +
                      "), the one stationary point inside the lobe; there cos^n goes from 0.5 (n = 1) to " +
                      number(level_low) + " (n = 1000) and the error from " +
                      percent(cosine_quadratic(2.0, 2.0 / 3) / std::pow(2.0 / 3, 2) - 1) + " (n = 2) to " +
                      percent(cosine_quadratic(1000.0, 1000.0 / 1001) / level_low - 1) +
                      " (n = 1000); towards the root, where the lobe is 0, it reaches 100 %",
                  std::string(kAmbiguous) +
                      ": a local extremum; the level lies in 0.2..0.4 for n >= " + std::to_string([] {
                        int n = 1;
                        while (std::pow(n / (n + 1.0), n) > 0.4) ++n;
                        return n;
                      }())});
  const auto foot = worst_over(3, kMaxExponent, [](int n) {
    return std::abs(std::cos(std::atan(std::sqrt(6.0 * n - 3) / (n - 2))) - (n - 2.0) / (n + 1));
  });
  const auto foot_error = worst_over(3, kMaxExponent, [](int n) { return std::pow((n - 2.0) / (n + 1), n); });
  const auto whole = worst_whole(lobe::cosine_quadratic);
  const auto& errors = errors_of(lobe::cosine_quadratic);
  rows.push_back({"T16", "2.3",
                  "in the blooming zone the absolute error is largest at gamma = arctg(sqrt(6n - 3)/(n - 2)) "
                  "and at most 0.1",
                  "cos of that angle is (n - 2)/(n + 1), the lobe's root (to " + number(foot.value, 2) +
                      "), where the error is cos^n, at most " + at(foot_error) +
                      "; over the whole range the largest is " + at(whole) +
                      ", for n = 100 at cos^n = " + number(std::pow(errors[99].whole.cos, 100)),
                  verdict_of_parts(std::vector<reading>{{"at the root", foot_error.value <= 0.1},
                                                        {"over the whole range", whole.value <= 0.1}})});
  rows.push_back(measured_against({"T17", "2.7, 3.1, conclusions",
                                   "the cosine-quadratic's relative error is not more than 3 % in the "
                                   "epicentre (and the attenuation zone)",
                                   kCosineQuadratic, 0.03}));
  rows.push_back(ratio_claim("T18", "3.1",
                             "its absolute error in the epicentre is 4 times less than Schlick's",
                             lobe::cosine_quadratic, 4, false));
  rows.push_back(ratio_claim("T19", "3.4",
                             "its absolute error in the epicentre is 3 times less than Schlick's",
                             lobe::cosine_quadratic, 3, false));
  const auto faster = [](const std::string& real) {
    return recorded_speed(real + "/cosine-quadratic") / recorded_speed(real + "/schlick");
  };
  rows.push_back(
      {"T20", "3.1, 3.4", "in software it is 1.7 times as fast as Schlick's",
       "operations per value: Schlick 1 division, 1 product, 2 sums; cosine-quadratic 2 products, 2 sums, 1 "
       "comparison, (n + 1)/3 known. [On one machine](tables/speed.csv), vectorised: " +
           number(faster("double"), 2) + " times in double, " + number(faster("float"), 2) +
           " in float; on another, `build/bin/bench_golden`",
       std::string(kAmbiguous) + ": depends on the processor"});
  rows.push_back({"T21", "fig. 3.13 (3.12 b)",
                  "pictures are rendered up to 20 % faster than with Blinn's model",
                  "takes the renderer and its pictures, which are not given. [On one "
                  "machine](tables/speed.csv) a value of the "
                  "lobe alone takes 1/" +
                      number(recorded_speed("double/cosine-quadratic") / recorded_speed("double/blinn"), 2) +
                      " of the time of Blinn's",
                  std::string(kUncheckable)});
}

void add_shifts(std::vector<claim>& rows) {
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
  rows.push_back({"T26", "table 2.1", "225 additions for the points of the rows",
                  "75 points by 3 colours; the triangle's place on the grid, which decides their number, is "
                  "not given (the text says 100 points)",
                  std::string(kUncheckable)});
  rows.push_back({"T41", "2.4", "a row of an average triangle of 100 pixels has at most 16 pixels",
                  "no distribution of triangles is given; the device's tables cover k = 2..16",
                  std::string(kUncheckable)});
  rows.push_back({"T27", "2.4", "2946 cycles of a Pentium M against 2064: 1.43 times as fast",
                  "2946/2064 = " + number(2946.0 / 2064, 4) + "; the cycles themselves need that processor",
                  verdict_of_parts(std::vector<reading>{{"the quotient", rounds_to(2946.0 / 2064, 1.43, 2)},
                                                        {"the cycles", false}})});
}

void add_energy(std::vector<claim>& rows) {
  const auto published_limit = [](int n) { return 5.8 / std::sqrt(n); };
  const auto true_limit = [](int n) {
    return std::min(boost::math::constants::half_pi<double>(),
                    2 * std::acos(std::max(-1.0, (n - 2.0) / (n + 1))));
  };
  rows.push_back(
      {"T28", "(2.25)", "the first lobe ends at theta = 5.8/sqrt(n)",
       "its root is 2 arccos((n - 2)/(n + 1)): sqrt(n) theta is " +
           number(2 * std::acos(0.8) * std::sqrt(14.0)) + " at n = 14 and " +
           number(2 * std::acos(998.0 / 1001) * std::sqrt(1000.0), 4) +
           " at n = 1000 (2 sqrt(6) in the limit), so the integral takes in a part of the second lobe",
       verdict_of(false)});
  std::string as_printed = excess([&](int n) { return published_integral(n, published_limit(n)); });
  std::string clipped = excess([&](int n) {
    return published_integral(n, std::min(boost::math::constants::half_pi<double>(), published_limit(n)));
  });
  std::string first_lobe = excess([&](int n) { return published_integral(n, true_limit(n)); });
  rows.push_back({"T29", "fig. 2.15", "R of the cosine-quadratic exceeds 1 for n in [1; 17]",
                  "n with R > 1 at normal incidence: integrated to 5.8/sqrt(n) " + as_printed +
                      "; the same clipped at 90 degrees " + clipped + "; the first lobe alone " + first_lobe,
                  verdict_of(std::vector<reading>{{"5.8/sqrt(n)", as_printed == "1..17"},
                                                  {"clipped at 90 degrees", clipped == "1..17"},
                                                  {"first lobe", first_lobe == "1..17"}})});
  const auto energy = worst_over(
      1, kMaxExponent, [&](int n) { return (n + 6) / 24.55 * published_integral(n, true_limit(n)); });
  const auto energy_printed = worst_over(
      1, kMaxExponent, [&](int n) { return (n + 6) / 24.55 * published_integral(n, published_limit(n)); });
  const auto energy_oblique = worst_over(1, kMaxExponent, [&](int n) {
    return lobe_reflectance(lobe::cosine_quadratic_energy, n, lobe_axis::half_vector, 60);
  });
  const std::string energy_range =
      excess([&](int n) { return (n + 6) / 24.55 * published_integral(n, true_limit(n)); });
  rows.push_back(
      {"T30", "(2.26), fig. 2.16", "(n + 6)/24.55 makes it energy-correct for n in [1; 1000]",
       "largest R at normal incidence, first lobe: " + at(energy, 6) + ", R > 1 for n = " + energy_range +
           "; integrated to 5.8/sqrt(n): " + at(energy_printed, 6) + "; at 60 degrees " +
           at(energy_oblique, 6),
       verdict_of_parts(std::vector<reading>{{"normal incidence", energy.value <= 1},
                                             {"integrated to 5.8/sqrt(n)", energy_printed.value <= 1},
                                             {"60 degrees", energy_oblique.value <= 1}})});
  const auto blinn_energy = worst_over(1, kMaxExponent, [&](int n) {
    return lobe_reflectance(lobe::blinn_normalised, n, lobe_axis::half_vector, 0);
  });
  rows.push_back({"T31", "fig. 2.16", "(n + 6)/(8 pi) normalises Blinn's lobe",
                  "largest R at normal incidence over n = 1..1000: " + at(blinn_energy, 6) + "; R(1) = " +
                      number(lobe_reflectance(lobe::blinn_normalised, 1, lobe_axis::half_vector, 0), 4) +
                      ", R(1000) = " +
                      number(lobe_reflectance(lobe::blinn_normalised, 1000, lobe_axis::half_vector, 0), 6),
                  verdict_of(blinn_energy.value <= 1)});
  rows.push_back({"T32", "(2.24)", "at normal incidence the half vector's cosine is cos(theta)/2 as printed",
                  "cos(theta/2) is meant, as (2.25) has it: at theta = 0 the printed term is 1/2, not 1",
                  verdict_of(false)});
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

void add_pictures(std::vector<claim>& rows) {
  const auto nmse_claim = [](std::string id, std::string place, std::string says,
                             const std::vector<std::pair<std::string, lobe>>& lobes, double limit, int first,
                             int last) {
    std::string text;
    std::vector<reading> readings;
    for (const auto& [name, which] : lobes) {
      for (const auto& scene : kPictureScenes) {
        const worst w = worst_nmse(which, scene, first, last);
        append(text, "; ", name, ", ", scene.name, " ", number(w.value, 2), " (n = ", std::to_string(w.n),
               ")");
        readings.push_back({name + " (" + std::string(scene.name) + ")", w.value <= limit});
      }
    }
    return claim{std::move(id), std::move(place), std::move(says),
                 "sphere, largest over the exponents tried: " + text + ". [By n](tables/nmse.md)",
                 verdict_of(readings)};
  };
  rows.push_back(nmse_claim("T33", "3.1, 3.4, table 3.2",
                            "the cosine-quadratic's NMSE is at most 0.00008, below 0.0001", kCosineQuadratic,
                            0.00008, 1, 1000));
  rows.push_back(nmse_claim("T34", "table 3.2", "the modified Schlick's NMSE is at most 0.00011", kModified,
                            0.00011, 1, 1000));
  rows.push_back(nmse_claim("T35", "table 3.2", "the quadratic's NMSE is at most 0.00026 for n < 170",
                            kQuadratics, 0.00026, 1, 169));
  rows.push_back(
      nmse_claim("T36", "table 3.2", "and below 0.0002 for other n", kQuadratics, 0.0002, 170, 1000));
  rows.push_back(
      {"T37", "3.4",
       "visible difference by NMSE: none up to 1e-4, slight to 2.5e-4, visible to 1e-3, then strong",
       "a convention; the tables here use it", std::string(kUncheckable)});
  rows.push_back({"T38", "table 3.2, teapot", "the same NMSE limits for Newell's teapot",
                  "takes the teapot's size and place in the picture, and the light, which are not given",
                  std::string(kUncheckable)});
  rows.push_back(segment_tracing());
  rows.push_back({"T40", "3.1",
                  "the device takes two ROMs, two adders, five registers, five multipliers, a comparator and "
                  "a key block",
                  "takes a model of the device, which does not exist yet", std::string(kUncheckable)});
}

}  // namespace

std::vector<claim> thesis_claims() {
  std::vector<claim> rows;
  add_schlick(rows);
  add_quadratic(rows);
  add_cosine_quadratic(rows);
  add_shifts(rows);
  add_energy(rows);
  add_pictures(rows);
  return rows;
}

}  // namespace blysk::golden
