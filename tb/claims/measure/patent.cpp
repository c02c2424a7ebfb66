// SPDX-License-Identifier: Apache-2.0
// [P]: patent UA 60553.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "tb/claims/measure/over_exponents.h"
#include "tb/claims/speed.h"

namespace blysk::claims {

using namespace golden;
namespace {

figures distance_of_lines() {
  const auto line = [](double slope, double offset) {
    return worst_over(1, kMaxExponent,
                      [=](int n) { return std::abs(slope * n + offset - exact_coefficient(1.0 * n)); });
  };
  const double slope = coefficient_slope<double>();
  figures result{{"slope", slope}, {"offset", exact_coefficient(1000.0) - 1000 * slope}};
  add_worst(result, "printed", line(0.786, 0.5));
  add_worst(result, "turned", line(0.786, -0.5));
  add_worst(result, "derived", line(slope, -0.5));
  return result;
}

figures errors_of_lines() {
  figures result;
  for (const auto& [key, which] : {std::pair{"published", lobe::quadratic_published},
                                   {"derived", lobe::quadratic_derived},
                                   {"exact", lobe::quadratic_exact}}) {
    add_worst(result, key, worst_whole(which));
    add_worst_percent(result, fmt::format("{}_056", key), worst_relative(which, epicentre::level_056));
  }
  return result;
}

/// Time of a point, of one by itself and of one in a scan line.
figures times_of_angle() {
  figures result;
  std::map<std::string, double> times;
  for (const char* device : {"quadratic", "angle", "arccos"}) {
    const double cycles = recorded_price(device, "cycles");
    const double path = recorded_price(device, "path_ns");
    result[fmt::format("{}_cycles", device)] = cycles;
    result[fmt::format("{}_ns", device)] = path;
    times[device] = cycles * path;
  }
  result["apart"] = (times["arccos"] + times["angle"]) / times["quadratic"];
  result["line"] = recorded_price("angle", "path_ns") / times["quadratic"];
  return result;
}

/// The prototype's cost over that of UA 60553.
figures costs_of_memory() {
  const auto of = [](const char* device) {
    return std::pair(recorded_cost(device, "osu018", "area_nand2"), recorded_cost(device, "ice40", "lut"));
  };
  const auto [area, luts] = of("quadratic");
  const auto [memory_area, memory_luts] = of("quadratic_rom");
  const double blocks = recorded_cost("quadratic_rom", "ice40", "ram_bits") / 4096;
  return {{"area", area},
          {"memory_area", memory_area},
          {"larger", memory_area / area},
          {"luts", luts},
          {"memory_luts", memory_luts},
          {"blocks", blocks},
          {"more_luts", memory_luts / luts}};
}

}  // namespace

void measure_patent(measurements& into) {
  into["P1"] = [] {
    const auto ends = worst_over(1, kMaxExponent, [](int n) {
      return std::max(std::abs(quadratic(coefficient_line::exact, 1.0 * n, 1.0) - 1),
                      std::abs(quadratic(coefficient_line::exact, 1.0 * n, 0.0)));
    });
    return figures{{"gap", ends.value}};
  };
  into["P2"] = [] {
    // d2/dx2 cos^n x = n cos^(n-2) x ((n-1) sin^2 x - cos^2 x)
    const auto factor = worst_over(2, kMaxExponent, [](int n) {
      const double gamma = std::atan(1 / std::sqrt(n - 1.0));
      return std::abs((n - 1) * std::pow(std::sin(gamma), 2) - std::pow(std::cos(gamma), 2));
    });
    return figures{{"factor", factor.value}};
  };
  into["P3"] = [] {
    // t carries a roundoff or two, which t^n multiplies by n.
    const auto gap = worst_over(2, kMaxExponent, [](int n) {
      const double t = std::sqrt((n - 1.0) / n);
      return std::abs(quadratic(coefficient_line::exact, 1.0 * n, t) - std::pow(t, n)) / n;
    });
    return figures{{"gap", gap.value}};
  };
  into["P4"] = distance_of_lines;
  into["P5"] = errors_of_lines;
  into["P7"] = costs_of_memory;
  into["P8"] = times_of_angle;
  into["P6"] = [] {
    const double words = std::exp2(std::ceil(std::log2(kMaxExponent)));
    const double width = 8 * 2048 / words;
    const double a = exact_coefficient(1000.0);
    return figures{
        {"words", words}, {"width", width}, {"a", a}, {"fraction", width - std::ceil(std::log2(a))}};
  };
}

}  // namespace blysk::claims
