// SPDX-License-Identifier: Apache-2.0
// [T]: the thesis.
#include <algorithm>
#include <cmath>
#include <functional>

#include "tb/claims/claim.h"
#include "tb/claims/pictures.h"
#include "tb/claims/speed.h"
#include "tb/claims/sweep.h"
#include "tb/claims/table_form.h"
#include "tb/claims/thesis_arithmetic.h"

namespace blysk::golden {
namespace {

/// Something that stands for cos^n, and its largest relative error by epicentre and exponent.
struct candidate {
  std::string name;
  std::function<double(epicentre where, int n)> error;
};

candidate lobe_candidate(std::string name, lobe which) {
  return {std::move(name), [which](epicentre where, int n) {
            return errors_of(which)[static_cast<std::size_t>(n) - 1]
                .relative[static_cast<std::size_t>(where)]
                .value;
          }};
}

/// Which n of [first, last] obey a limit, as words.
std::string met_for(int first, int last, const std::function<bool(int)>& holds) {
  std::vector<bool> members(static_cast<std::size_t>(last), false);
  for (int n = first; n <= last; ++n) members[static_cast<std::size_t>(n) - 1] = holds(n);
  const std::string result = ranges(members);
  return result == "none" ? "no n" : "n in " + result;
}

/// "3.2 % or less in the highlight": largest relative error of each candidate in each epicentre, against one limit.
struct relative_claim {
  std::string id, place, says;
  std::vector<candidate> candidates;
  double limit;
  int last = kMaxExponent;
  std::string note = "";
};

claim measured_against(const relative_claim& c) {
  std::string text;
  std::vector<reading> readings;
  for (const candidate& each : c.candidates) {
    append(text, "; ", each.name, ": ");
    std::string separator;
    for (const epicentre where : kEpicentres) {
      const int first = first_exponent(where);
      const worst w = worst_over(first, c.last, [&](int n) { return each.error(where, n); });
      append(text, "", separator, name_of(where), " ", percent_at(w), ", met for ",
             met_for(first, c.last, [&](int n) { return each.error(where, n) <= c.limit; }));
      separator = ", ";
      readings.push_back({each.name + " (" + std::string(name_of(where)) + ")", w.value <= c.limit});
    }
  }
  return {c.id, c.place, c.says, "largest, and for which n the limit is met: " + text + c.note,
          verdict_of(readings)};
}

/// Errors of Schlick's lobe over those of another, worst over n against worst over n, by epicentre, and the n at which
/// the ratio is reached.
claim ratio_claim(std::string id, std::string place, std::string says, lobe better, double factor,
                  bool relative) {
  std::string text;
  std::vector<reading> readings;
  const auto compare = [&](std::string_view name, int first, const auto& error) {
    const auto largest = [&](lobe which) {
      return worst_over(first, kMaxExponent, [&](int n) { return error(which, n); }).value;
    };
    const double ratio = largest(lobe::schlick) / largest(better);
    append(text, "; ", name, " ", number(ratio), " times, n by n met for ",
           met_for(first, kMaxExponent, [&](int n) {
             const double schlick = error(lobe::schlick, n);
             return schlick > kRounding && schlick >= factor * error(better, n);
           }));
    readings.push_back({std::string(name), ratio >= factor});
  };
  const auto at_exponent = [](lobe which, int n) -> const error_summary& {
    return errors_of(which)[static_cast<std::size_t>(n) - 1];
  };
  for (const epicentre where : kEpicentres) {
    compare(name_of(where), first_exponent(where), [&](lobe which, int n) {
      const auto& e = at_exponent(which, n);
      return (relative ? e.relative : e.absolute)[static_cast<std::size_t>(where)].value;
    });
  }
  if (!relative)
    compare("the whole range", 1, [&](lobe which, int n) { return at_exponent(which, n).whole.value; });
  return {std::move(id), std::move(place), std::move(says),
          "largest errors over n = 1..1000, Schlick's over the other's: " + text, verdict_of(readings)};
}

/// The n from 3 on, as the exact quadratic has no error at n = 1 and 2.
claim evenness(std::string id, std::string place, std::string says, lobe which) {
  const auto share = [&](int n) {
    const auto& e = errors_of(which)[static_cast<std::size_t>(n) - 1];
    return e.rms / e.whole.value;
  };
  const worst least = worst_over(3, kMaxExponent, [&](int n) { return -share(n); });
  return {std::move(id), std::move(place), std::move(says),
          "rms over largest absolute error over cos in [0, 1], n = 3..1000, which evenness would make 1: " +
              number(share(10)) + " at n = 10, " + number(share(100)) + " at n = 100, least " +
              at({-least.value, least.n}),
          std::string(kAmbiguous) + ": evenness is not defined"};
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

std::vector<candidate> candidates(const std::vector<std::pair<std::string, lobe>>& lobes) {
  std::vector<candidate> result;
  result.reserve(lobes.size());
  for (const auto& [name, which] : lobes) result.push_back(lobe_candidate(name, which));
  return result;
}

/// What (2.2) can mean, and what table 3.2 prints in its place.
std::vector<candidate> modified_candidates() {
  auto result = candidates(kModified);
  result.push_back({"reading E", table_form_error});
  return result;
}

void add_schlick(std::vector<claim>& rows) {
  const std::vector<candidate> schlick_alone = candidates({{"Schlick", lobe::schlick}});
  rows.push_back(measured_against(
      {"T1", "2.1", "Schlick's largest relative error is not more than 3.2 %", schlick_alone, 0.032}));
  std::string text;
  std::vector<reading> readings;
  for (const epicentre where : kEpicentres) {
    const worst w = worst_relative(lobe::schlick, where);
    append(text, ", ", name_of(where), " ", percent_at(w));
    readings.push_back({std::string(name_of(where)), rounds_to(100 * w.value, 10, 0)});
  }
  rows.push_back({"T2", "2.7, 3.4, conclusions", "Schlick's largest relative error in the highlight is 10 %",
                  text, verdict_of(readings)});
  text.clear();
  for (const int n : {1, 2, 10, 100, 1000}) {
    append(text, ", ", "n = ", std::to_string(n), ": ",
           percent(schlick_alone.front().error(epicentre::level_060, n)));
  }
  const double limit = 1 / (0.6 * (1 - std::log(0.6))) - 1;
  rows.push_back(
      {"T42", "fig. 2.3", "Schlick's largest relative error by n, cos^n from 1 to 0.6",
       text + "; towards 1/(0.6 (1 - ln 0.6)) - 1 = " + percent(limit, 4) +
           " for large n. [Picture](figures/thesis_fig2_3.svg). The seed's text keeps no number of "
           "its curve but those of T1 and T2",
       std::string(kUncheckable)});
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
  const auto modified = modified_candidates();
  const std::string note =
      ". E is the form of table 3.2, its a fitted to each n and epicentre for the least error";
  rows.push_back(measured_against(
      {"T4", "2.7, conclusions",
       "the modified Schlick's largest relative error in the highlight is not more than 3.2 %", modified,
       0.032, kMaxExponent, note}));
  rows.push_back(measured_against(
      {"T5", "3.4", "the modified Schlick's largest relative error in the highlight is not more than 0.4 %",
       modified, 0.004, kMaxExponent, note}));
  text.clear();
  readings.clear();
  for (const auto& [name, error] : modified) {
    std::string differences;
    for (const epicentre where : kEpicentres) {
      const int first = first_exponent(where);
      const double difference =
          worst_relative(lobe::schlick, where).value -
          worst_over(first, kMaxExponent, [&, &e = error](int n) { return e(where, n); }).value;
      append(differences, ", ", name_of(where), " ", number(100 * difference));
      readings.push_back(
          {name + " (" + std::string(name_of(where)) + ")", rounds_to(100 * difference, 6.8, 1)});
    }
    append(text, "; ", name, ": ", differences);
  }
  rows.push_back({"T6", "2.1", "the modification's largest relative error differs from Schlick's by 6.8 %",
                  "Schlick's less the other's, in percentage points; " + text, verdict_of(readings)});
  text.clear();
  for (const epicentre where : kEpicentres) {
    append(text, ", ", name_of(where), " ",
           percent_at(worst_over(first_exponent(where), kMaxExponent,
                                 [&](int n) { return table_form_error(where, n); })));
  }
  rows.push_back({"T7", "table 3.2, 3.4", "the modified Schlick as cos^a x / (n - n cos x + cos x)",
                  "(2.2) is another form, and a is nowhere given. With the a that makes the error of each n "
                  "least, the largest is " +
                      text + ": reading E of T4 and T5",
                  std::string(kAmbiguous) + ": no a is given"});
}

void add_quadratic(std::vector<claim>& rows) {
  rows.push_back(
      measured_against({"T8", "2.2", "the quadratic's relative error is not more than 3 % in the epicentre",
                        candidates(kQuadratics), 0.03}));
  const double tail =
      largest_relative_error(clamped_lobe(lobe::quadratic_exact, 100), 100, std::pow(0.1, 0.01)).value;
  rows.push_back({"T9", "2.2", "and not more than 3 % in the attenuation zone too",
                  "exact a, n = 100, down to cos^n = 0.1: " + percent(tail) + "; the lobe ends at cos^n = " +
                      number(std::pow(root_cosine(lobe::quadratic_exact, 100), 100)) +
                      ", from where on it is 100 %",
                  verdict_of(tail <= 0.03)});
  rows.push_back(measured_against(
      {"T10", "conclusions", "the quadratic keeps the epicentre within 2 %", candidates(kQuadratics), 0.02}));
  rows.push_back(measured_against(
      {"T11", "fig. 2.7", "level 0.56 and above, n in [1; 512]: the largest relative error is 3 % (2.2)",
       candidates(kQuadratics), 0.03, 512}));
  rows.push_back(ratio_claim("T12", "3.4",
                             "the quadratic is more than 10 times as exact in the epicentre (as Schlick's)",
                             lobe::quadratic_exact, 10, true));
  rows.push_back(evenness("T13", "introduction",
                          "the quadratic spreads its absolute error evenly over the whole interval",
                          lobe::quadratic_exact));
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
       "largest relative difference, divided by n, over n = 2..1000: " + number(area.value, 2) +
           ". At n = 1 the root lies beyond 90 degrees, and the area is " + number(26.0 / 54) +
           " in place of 0.5",
       verdict_of_parts(std::vector<reading>{{"n in 2..1000", area.value < kRounding}, {"n = 1", false}})});
  rows.push_back(evenness("T43", "after (2.15)",
                          "the cosine-quadratic spreads its absolute error evenly over the whole interval",
                          lobe::cosine_quadratic));
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
  std::string by_exponent;
  for (const int n : {1, 2, 10, 100, 1000}) {
    append(by_exponent, "; ", "n = ", std::to_string(n), ": ",
           percent(candidates(kCosineQuadratic).front().error(epicentre::level_060, n)), ", ",
           percent(cosine_quadratic<double>(n, n / (n + 1.0)) / std::pow(n / (n + 1.0), n) - 1));
  }
  rows.push_back({"T44", "fig. 2.10", "the cosine-quadratic's largest relative error by n",
                  "where c^n >= 0.6, and at the stationary point of T15: " + by_exponent +
                      ". [Picture](figures/thesis_fig2_10.svg). The seed's text keeps no number of its curve",
                  std::string(kUncheckable)});
  rows.push_back(measured_against({"T17", "2.7, 3.1, conclusions",
                                   "the cosine-quadratic's relative error is not more than 3 % in the "
                                   "epicentre (and the attenuation zone)",
                                   candidates(kCosineQuadratic), 0.03}));
  rows.push_back(ratio_claim("T18", "3.1",
                             "its absolute error in the epicentre is 4 times less than Schlick's",
                             lobe::cosine_quadratic, 4, false));
  rows.push_back(ratio_claim("T19", "3.4",
                             "its absolute error in the epicentre is 3 times less than Schlick's",
                             lobe::cosine_quadratic, 3, false));
  const auto faster = [](const std::string& how, const std::string& other) {
    return number(recorded_speed(how + "/cosine-quadratic") / recorded_speed(how + "/" + other), 2);
  };
  const std::string record =
      "On one machine, g++ -O3 ([record](tables/speed.csv), again by `build/bin/bench_golden`): ";
  rows.push_back(
      {"T20", "3.1, 3.4", "in software it is 1.7 times as fast as Schlick's",
       "operations per value: Schlick 1 division, 1 product, 2 sums; cosine-quadratic 2 products, 2 sums, 1 "
       "comparison, (n + 1)/3 known. " +
           record + "in a loop that does one value after the other, as [T]'s Java does, " +
           faster("scalar", "schlick") + " times in double; vectorised " + faster("double", "schlick") +
           " times in double, " + faster("float", "schlick") + " in float",
       std::string(kAmbiguous) + ": depends on the processor and on the loop"});
  rows.push_back(
      {"T21", "fig. 3.13 (3.12 b)", "pictures are rendered up to 20 % faster than with Blinn's model",
       record + "a picture of the sphere, 512 x 512, n = 50, normals and all, is made " +
           faster("sphere", "blinn") + " times as fast as with Blinn's lobe by std::pow; the lobe alone is " +
           faster("scalar", "blinn") + " times as fast one by one, " + faster("double", "blinn") +
           " vectorised. How much of a frame the lobe takes depends on the rest of the renderer, which is "
           "not "
           "given",
       std::string(kAmbiguous) + ": depends on the renderer"});
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
  rows.push_back({"T30", "(2.26), fig. 2.16", "(n + 6)/24.55 makes it energy-correct for n in [1; 1000]",
                  "largest R at normal incidence, first lobe: " + at(energy, 6) + ", R > 1 for n = " +
                      energy_range + "; integrated to 5.8/sqrt(n): " + at(energy_printed, 6) +
                      "; at 60 degrees " + at(energy_oblique, 6),
                  verdict_of(std::max({energy.value, energy_printed.value, energy_oblique.value}) <= 1)});
  const auto gain = worst_over(1, kMaxExponent, [](int n) {
    double oblique = 0;
    for (const double degrees : {15.0, 30.0, 45.0, 60.0, 80.0})
      oblique =
          std::max(oblique, lobe_reflectance(lobe::cosine_quadratic, n, lobe_axis::half_vector, degrees));
    return oblique / lobe_reflectance(lobe::cosine_quadratic, n, lobe_axis::half_vector, 0);
  });
  rows.push_back({"T45", "before (2.24)", "the surface is lit most at normal incidence, so R is tested there",
                  "R of the cosine-quadratic at 15, 30, 45, 60 and 80 degrees over that at 0: at most " +
                      at(gain) + " over n = 1..1000",
                  verdict_of(gain.value < 1)});
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

void add_pictures(std::vector<claim>& rows) {
  const auto nmse_claim = [](std::string id, std::string place, std::string says,
                             const std::vector<std::pair<std::string, std::string_view>>& lobes, double limit,
                             int first, int last) {
    std::string text;
    std::vector<reading> readings;
    for (const auto& [name, which] : lobes) {
      append(text, "; ", name, ": ");
      std::string separator;
      for (const auto& scene : kPictureScenes) {
        const auto value = [&, lobe_name = which](int n) { return sphere_nmse(lobe_name, scene, n); };
        const worst w = worst_over(first, last, value);
        append(text, "", separator, scene.name, " ", at(w, 2), ", met for ",
               met_for(first, last, [&](int n) { return value(n) <= limit; }));
        separator = ", ";
        readings.push_back({name + " (" + std::string(scene.name) + ")", w.value <= limit});
      }
    }
    return claim{std::move(id), std::move(place), std::move(says),
                 "sphere, by shares of the light, largest over every n, and for which n the limit is met: " +
                     text + ". [By n](tables/nmse.md)",
                 verdict_of(readings)};
  };
  const auto names = [](const std::vector<std::pair<std::string, lobe>>& lobes) {
    std::vector<std::pair<std::string, std::string_view>> result;
    result.reserve(lobes.size() + 1);
    for (const auto& [name, which] : lobes) result.emplace_back(name, name_of(which));
    return result;
  };
  auto modified = names(kModified);
  modified.emplace_back("reading E", table_form::kName);
  rows.push_back(nmse_claim("T33", "3.1, 3.4, table 3.2",
                            "the cosine-quadratic's NMSE is at most 0.00008, below 0.0001",
                            names(kCosineQuadratic), 0.00008, 1, kMaxExponent));
  rows.push_back(nmse_claim("T34", "table 3.2", "the modified Schlick's NMSE is at most 0.00011", modified,
                            0.00011, 1, kMaxExponent));
  rows.push_back(nmse_claim("T35", "table 3.2", "the quadratic's NMSE is at most 0.00026 for n < 170",
                            names(kQuadratics), 0.00026, 1, 169));
  rows.push_back(nmse_claim("T36", "table 3.2", "and below 0.0002 for other n", names(kQuadratics), 0.0002,
                            170, kMaxExponent));
  rows.push_back(
      {"T37", "3.4",
       "visible difference by NMSE: none up to 1e-4, slight to 2.5e-4, visible to 1e-3, then strong",
       "a convention; the tables here use it", std::string(kUncheckable)});
  rows.push_back(
      {"T38", "table 3.2, teapot", "the same NMSE limits for Newell's teapot",
       "the sphere shows every visible normal once, whatever its size, so that light, view and shares "
       "alone are left to be tried (T33 to T36). How many pixels of the teapot hold a highlight "
       "depends on its pose and place as well, which are not given; its NMSE can be any share of the "
       "lobe's error",
       std::string(kUncheckable)});
}

}  // namespace

std::vector<claim> thesis_claims() {
  std::vector<claim> rows;
  add_schlick(rows);
  add_quadratic(rows);
  add_cosine_quadratic(rows);
  add_gouraud(rows);
  add_energy(rows);
  add_pictures(rows);
  add_devices(rows);
  return rows;
}

}  // namespace blysk::golden
