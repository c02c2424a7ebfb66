// SPDX-License-Identifier: Apache-2.0
// NMSE of pictures made as calcColor of [T] listing A makes them, pixel by pixel.
#include <fmt/format.h>

#include <functional>

#include "tb/catch.h"
#include "tb/claims/test/literal.h"
#include "tb/claims/test/second.h"

namespace blysk::claims {
namespace {

using namespace literal;

struct scene {
  const char* key;
  std::array<int, 3> colour;
  double share;  ///< k_d and k_s
};

constexpr std::array kScenes{scene{"orange", {238, 138, 32}, 1}, scene{"half", {238, 138, 32}, 0.5},
                             scene{"white", {255, 255, 255}, 1}};

struct sphere_point {
  double cos_light, cos_half;
};

/// Light (0.4, 0.5, 0.75), view (0, 0, 1), 512 x 512 pixels, radius 0.9 of half the side; from left below.
const std::vector<sphere_point>& sphere() {
  static const auto result = [] {
    std::vector<sphere_point> points;
    const double length = std::sqrt(0.16 + 0.25 + 0.5625);
    // |L + V|^2 = 2 + 2 L.V for unit vectors
    const double half_length = std::sqrt(2 + 2 * 0.75 / length);
    for (int j = -256; j < 256; ++j) {
      for (int i = -256; i < 256; ++i) {
        const double x = (i + 0.5) / (256 * 0.9);
        const double y = (j + 0.5) / (256 * 0.9);
        if (x * x + y * y >= 1) continue;
        const double z = std::sqrt(1 - x * x - y * y);
        const double light = (0.4 * x + 0.5 * y + 0.75 * z) / length;
        points.push_back({std::max(0.0, light), std::max(0.0, (light + z) / half_length)});
      }
    }
    return points;
  }();
  return result;
}

/// Energy of a scene without any highlight.
double plain_energy(const scene& s) {
  double result = 0;
  for (const auto& p : sphere()) {
    for (const int colour : s.colour) {
      const int base = colour * static_cast<int>(p.cos_light * s.share * 255) / 255;
      result += base * base;
    }
  }
  return result;
}

/// Smallest cosine at which a lobe that rises with it reaches 1/255.
double visible_from(const std::function<double(double)>& f) {
  double low = 0;
  double high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (255 * f(middle) >= 1 ? high : low) = middle;
  }
  return low;
}

/// NMSE in the three scenes.
std::array<double, 3> nmse(const std::function<double(double)>& reference,
                           const std::function<double(double)>& tried) {
  static const std::array<double, 3> plain{plain_energy(kScenes[0]), plain_energy(kScenes[1]),
                                           plain_energy(kScenes[2])};
  const double visible = std::min(visible_from(reference), visible_from(tried));
  std::array<double, 3> difference{};
  std::array<double, 3> energy = plain;
  for (const auto& p : sphere()) {
    if (p.cos_half < visible) continue;
    const double first = reference(p.cos_half);
    const double second = tried(p.cos_half);
    for (std::size_t s = 0; s < kScenes.size(); ++s) {
      const double share = kScenes[s].share;
      const int first_code = static_cast<int>(first * share * 255);
      const int second_code = static_cast<int>(second * share * 255);
      for (const int colour : kScenes[s].colour) {
        const int base = colour * static_cast<int>(p.cos_light * share * 255) / 255;
        const double a = std::min(255, base + first_code);
        const double b = std::min(255, base + second_code);
        difference[s] += (a - b) * (a - b);
        energy[s] += a * a - base * base;
      }
    }
  }
  for (std::size_t s = 0; s < kScenes.size(); ++s) difference[s] /= energy[s];
  return difference;
}

/// The a of reading E by bisection: the error at the edge of c^n >= 0.6 rises with n - a, and the dip inside falls.
double fitted_a(double n) {
  if (n == 1) return 1;
  const double edge = edge_of(zone::level_060, n);
  double low = 0;
  double high = n - 1;
  for (int i = 0; i < 60; ++i) {
    const double b = (low + high) / 2;
    const auto ratio = [&](double c) { return std::pow(c, -b) / (n - n * c + c); };
    const double dip = -largest([&](double c) { return 1 - ratio(c); }, edge, 1, 60);
    (ratio(edge) - 1 < -dip ? low : high) = b;
  }
  return n - low;
}

/// By exponent, entry 0 unused.
using by_scene = std::array<std::vector<double>, 3>;

by_scene measure(const std::function<std::function<double(double)>(int n)>& lobe) {
  by_scene result;
  for (auto& column : result) column.push_back(0);
  for (int n = 1; n <= 1000; ++n) {
    const auto values = nmse([n](double c) { return std::pow(c, n); }, lobe(n));
    for (std::size_t s = 0; s < values.size(); ++s) result[s].push_back(values[s]);
  }
  return result;
}

by_scene measure_lobe(double (*f)(double n, double c)) {
  return measure([f](int n) { return [=](double c) { return f(n, c); }; });
}

by_scene measure_parabola(double (*a_of)(double n)) {
  return measure([a_of](int n) { return [a = a_of(n)](double c) { return parabola(a, c); }; });
}

void add(figures& into, const std::string& name, const by_scene& values, double limit, int first, int last) {
  for (std::size_t s = 0; s < kScenes.size(); ++s) {
    const auto value = [&](int n) { return values[s][static_cast<std::size_t>(n)]; };
    const auto key = fmt::format("{}_{}", name, kScenes[s].key);
    const peak p = over_n(first, last, value);
    into[key] = p.value;
    into[key + "_n"] = static_cast<double>(p.n);
    into[key + "_met"] = where(first, last, [&](int n) { return value(n) <= limit; });
  }
}

}  // namespace

TEST_CASE("pictures by the literal listing", "[claims][full]") {
  std::map<std::string, figures> rows;
  add(rows["T33"], "cq", measure_lobe(cosine_quadratic), 0.00008, 1, 1000);
  for (const auto& [name, f] :
       {std::pair{"A", &reading_a}, {"B", &reading_b}, {"C", &reading_c}, {"D", &reading_d}})
    add(rows["T34"], name, measure_lobe(f), 0.00011, 1, 1000);
  add(rows["T34"], "E",
      measure([](int n) { return [n, a = fitted_a(n)](double c) { return reading_e(n, a, c); }; }), 0.00011,
      1, 1000);
  for (const auto& [name, a_of] :
       {std::pair{"exact", &exact_a}, {"published", &published_a}, {"derived", &derived_a}}) {
    const by_scene values = measure_parabola(a_of);
    add(rows["T35"], name, values, 0.00026, 1, 169);
    add(rows["T36"], name, values, 0.0002, 170, 1000);
  }
  check_rows("pictures by the literal listing", rows);
}

}  // namespace blysk::claims
