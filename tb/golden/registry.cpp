// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/registry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tb/golden/angle.h"
#include "tb/golden/lobe.h"
#include "tb/golden/reflectance.h"
#include "tb/golden/scene.h"
#include "tb/golden/shift_division.h"

namespace blysk::golden {
namespace {

using inputs_t = std::span<const double>;

[[noreturn]] void refuse(std::string_view argument, double value, std::string_view expected) {
  std::ostringstream message;
  message.precision(17);
  message << argument << " is " << value << ", expected " << expected;
  throw std::domain_error(message.str());
}

/// `inside` is false for NaN too, as every comparison with it is.
void require(bool inside, std::string_view argument, double value, std::string_view expected) {
  if (!inside) refuse(argument, value, expected);
}

void require_count(inputs_t inputs, std::size_t count) {
  require(inputs.size() == count, "number of inputs", static_cast<double>(inputs.size()),
          std::to_string(count));
}

void require_n(double n) {
  require(n >= 1 && n <= 1000, "n", n, "a number in [1, 1000]");
}

void require_level(double k, double q) {
  require(k >= 1 && k <= 1000, "k", k, "a number in [1, 1000]");
  require(q > 0 && q < 1, "q", q, "a number in (0, 1)");
}

void require_cosine(std::string_view argument, double value) {
  require(value >= 0 && value <= 1, argument, value, "a number in [0, 1]");
}

void require_positive_cosine(std::string_view argument, double value) {
  require(value > 0 && value <= 1, argument, value, "a number in (0, 1]");
}

void require_whole(std::string_view argument, double value, double first, double last,
                   std::string_view expected) {
  require(value >= first && value <= last && value == std::floor(value), argument, value, expected);
}

template <lobe Which>
double checked_lobe(inputs_t in) {
  require_count(in, 2);
  require_n(in[0]);
  require_cosine("cos", in[1]);
  return evaluate(Which, in[0], in[1]) + 0.0;  // the parabola at cos = 0 is -0
}

template <lobe Which>
constexpr model lobe_row(std::string_view formula, std::string_view source) {
  return {name_of(Which), "n,cos", formula, source, checked_lobe<Which>};
}

double checked_schlick_power(inputs_t in) {
  require_count(in, 3);
  require_n(in[0]);
  require(in[1] >= 0 && in[1] <= 1000, "a", in[1], "a number in [0, 1000]");
  require_cosine("cos", in[2]);
  return schlick_power(in[0], in[1], in[2]);
}

template <coefficient_line Line>
double checked_coefficient(inputs_t in) {
  require_count(in, 1);
  require_n(in[0]);
  return coefficient(Line, in[0]);
}

double checked_angle(inputs_t in) {
  require_count(in, 4);
  require_n(in[0]);
  require_level(in[1], in[2]);
  require(in[3] >= 0 && in[3] <= boost::math::constants::half_pi<double>(), "x", in[3],
          "an angle in [0, pi/2] radians");
  return angle_lobe(in[0], in[1], in[2], in[3]);
}

/// A function of n, k, q.
template <double (*Function)(double n, double k, double q)>
double checked_level(inputs_t in) {
  require_count(in, 3);
  require_n(in[0]);
  require_level(in[1], in[2]);
  return Function(in[0], in[1], in[2]);
}

double limit_of(double n, double k, double q) {
  return angle_limit(n, k, q);
}

double integral_of(double n, double k, double q) {
  return angle_integral(n, k, q, angle_limit(n, k, q));
}

double coefficient_of(double n, double k, double q) {
  return angle_coefficient_exact(n, k, q);
}

double safe_coefficient_of(double n, double k, double q) {
  return angle_coefficient_safe(n, k, q);
}

double checked_angle_coefficient_fitted(inputs_t in) {
  require_count(in, 3);
  const auto [n, k, q] = std::array{in[0], in[1], in[2]};
  require_n(n);
  require(k >= 1 && k <= 5, "k", k, "a number in [1, 5], where the fit was made");
  require((q >= 0.1 && q <= 0.4) || (q >= 0.5 && q <= 0.9), "q", q,
          "a number in [0.1, 0.4] or [0.5, 0.9], where the fit was made");
  require(n > k, "n", n, "more than k, where the fit was made");
  return angle_coefficient_fitted(n, k, q);
}

void require_incidence(double degrees) {
  require(degrees >= 0 && degrees < 90, "incidence", degrees, "an angle in [0, 90) degrees");
}

template <lobe Which, lobe_axis Axis>
double checked_reflectance(inputs_t in) {
  require_count(in, 2);
  require_n(in[0]);
  require_incidence(in[1]);
  return lobe_reflectance(Which, in[0], Axis, in[1]);
}

template <lobe_axis Axis>
double checked_angle_reflectance(inputs_t in) {
  require_count(in, 4);
  require_n(in[0]);
  require_level(in[1], in[2]);
  require_incidence(in[3]);
  return angle_reflectance(in[0], in[1], in[2], 1, Axis, in[3]);
}

void require_slope(double m) {
  require(m > 0 && m <= 1, "m", m, "a number in (0, 1]");
}

void require_index(double index) {
  require(index > 1 && index <= 1000, "index", index, "a number in (1, 1000]");
}

void require_material(double m, double index) {
  require_slope(m);
  require_index(index);
}

template <facet_distribution Which>
double checked_cook_torrance_reflectance(inputs_t in) {
  require_count(in, 3);
  require_material(in[0], in[1]);
  require_incidence(in[2]);
  return cook_torrance_reflectance(Which, in[0], in[1], in[2]);
}

/// Three columns as the unit vector of their direction; `name` is that of the first, "nx".
vec3<double> direction(inputs_t in, std::size_t first, std::array<std::string_view, 3> names) {
  for (std::size_t i = 0; i < 3; ++i)
    require(std::isfinite(in[first + i]), names[i], in[first + i], "a finite number");
  const vec3<double> v{in[first], in[first + 1], in[first + 2]};
  require(v.x != 0 || v.y != 0 || v.z != 0, names[0], v.x, "a vector that is not zero");
  return normalised(v);
}

struct directions {
  vec3<double> normal, light, view;
};

/// The last nine of `count` columns.
directions all_directions(inputs_t in, std::size_t count) {
  require_count(in, count);
  return {direction(in, count - 9, {"nx", "ny", "nz"}), direction(in, count - 6, {"lx", "ly", "lz"}),
          direction(in, count - 3, {"vx", "vy", "vz"})};
}

double require_share(std::string_view name, double value) {
  require(value >= 0 && std::isfinite(value), name, value, "a finite number that is not negative");
  return value;
}

double checked_lambert(inputs_t in) {
  require_count(in, 10);
  const illumination<double> i{require_share("ia", in[0]), require_share("il", in[1]),
                               require_share("ka", in[2]), require_share("kd", in[3]), 0};
  return lambert(i, direction(in, 4, {"nx", "ny", "nz"}), direction(in, 7, {"lx", "ly", "lz"}));
}

/// n, the illumination, and the three vectors.
template <class Model>
double checked_shading(inputs_t in, const Model& shade) {
  const directions d = all_directions(in, 15);
  require_n(in[0]);
  const illumination<double> i{require_share("ia", in[1]), require_share("il", in[2]),
                               require_share("ka", in[3]), require_share("kd", in[4]),
                               require_share("ks", in[5])};
  return shade(i, in[0], d);
}

double checked_phong(inputs_t in) {
  return checked_shading(in, [](const auto& i, double n, const directions& d) {
    return phong(i, n, d.normal, d.light, d.view);
  });
}

double checked_blinn_shading(inputs_t in) {
  return checked_shading(in, [](const auto& i, double n, const directions& d) {
    return half_vector_shading(lobe::blinn, i, n, d.normal, d.light, d.view);
  });
}

double checked_half_cosine(inputs_t in) {
  const directions d = all_directions(in, 9);
  return clamped_cosine(d.normal, half_vector(d.light, d.view));
}

double checked_mirror_cosine(inputs_t in) {
  const directions d = all_directions(in, 9);
  return clamped_cosine(mirror_direction(d.normal, d.light), d.view);
}

double checked_fresnel(inputs_t in) {
  require_count(in, 2);
  require_index(in[0]);
  require_cosine("vh", in[1]);
  return fresnel(in[1], in[0]);
}

template <facet_distribution Which>
double checked_facets(inputs_t in) {
  require_count(in, 2);
  require_slope(in[0]);
  require_cosine("nh", in[1]);
  return facets(Which, in[1], in[0]);
}

/// The last four of `count` columns are nh, vh, nl, nv.
void require_four_cosines(inputs_t in, std::size_t count) {
  require_count(in, count);
  constexpr std::array<std::string_view, 4> kNames{"nh", "vh", "nl", "nv"};
  for (std::size_t i = 0; i < 4; ++i) require_positive_cosine(kNames[i], in[count - 4 + i]);
}

double checked_shadowing(inputs_t in) {
  require_four_cosines(in, 4);
  return shadowing(in[0], in[1], in[2], in[3]);
}

template <facet_distribution Which>
double checked_cook_torrance(inputs_t in) {
  const directions d = all_directions(in, 11);
  require_material(in[0], in[1]);
  return cook_torrance(Which, in[0], in[1], d.normal, d.light, d.view);
}

template <facet_distribution Which>
double checked_cook_torrance_cosines(inputs_t in) {
  require_four_cosines(in, 6);
  require_material(in[0], in[1]);
  return cook_torrance_of_cosines(Which, in[0], in[1], in[2], in[3], in[4], in[5]);
}

template <facet_distribution Which>
double checked_cook_torrance_mixed(inputs_t in) {
  const directions d = all_directions(in, 12);
  require_cosine("s", in[0]);
  require_material(in[1], in[2]);
  return cook_torrance_mixed(in[0], Which, in[1], in[2], d.normal, d.light, d.view);
}

/// k and the number of steps, from column `first`.
std::pair<uint32_t, int> shifts(inputs_t in, std::size_t first) {
  require_whole("k", in[first], 1, 0x1p31, "a whole number in [1, 2^31]");
  require_whole("steps", in[first + 1], 1, 31, "a whole number in [1, 31]");
  return {static_cast<uint32_t>(in[first]), static_cast<int>(in[first + 1])};
}

double checked_reciprocal(inputs_t in) {
  require_count(in, 2);
  const auto [k, steps] = shifts(in, 0);
  return shifted_quotient(1, k, steps);
}

double checked_shift_division(inputs_t in) {
  require_count(in, 3);
  require(std::isfinite(in[0]), "difference", in[0], "a finite number");
  const auto [k, steps] = shifts(in, 1);
  return shifted_quotient(in[0], k, steps);
}

constexpr std::array kSingleModels{
    lobe_row<lobe::blinn>("c^n", "[P] (1), [T] (2.11)"),
    lobe_row<lobe::blinn_normalised>("(n + 6)/(8 pi) c^n", "[T] fig. 2.16"),
    lobe_row<lobe::schlick>("c / (n - n c + c)", "[T] (1.5) (2.1)"),
    lobe_row<lobe::schlick_modified>("c / ((n (1 - c))^2 / 2 + n - n c + c)", "[T] (2.2), reading D"),
    lobe_row<lobe::schlick_modified_a>("c / (n (1 - c^2) / 2 + n - n c + c)", "[T] (2.2), reading A"),
    lobe_row<lobe::schlick_modified_b>("c / (n (1 - c)^2 / 2 + n - n c + c)", "[T] (2.2), reading B"),
    lobe_row<lobe::schlick_modified_c>("c / (n (1 - cos(acos(c)^2)) / 2 + n - n c + c)",
                                       "[T] (2.2), reading C"),
    lobe_row<lobe::quadratic_exact>("a (c^2 - c) + c, a = (t^(n-1) - 1)/(t - 1), t = sqrt((n-1)/n)",
                                    "[P] (3) (6) (9)"),
    lobe_row<lobe::quadratic_published>("a (c^2 - c) + c, a = 0.786 n + 0.5", "[P] (3) (6) (10)"),
    lobe_row<lobe::quadratic_derived>("a (c^2 - c) + c, a = 2 (1 - e^(-1/2)) n - 1/2",
                                      "[P] (3) (6), (9) expanded"),
    lobe_row<lobe::quadratic_energy_safe>(
        "f max(0, a (c^2 - c) + c), f = 3 a^2/(4 pi (3 a - 1)), or 3/(4 pi (3 - a)) for a < 1, a = 2 (1 - "
        "e^(-1/2)) n - 1/2",
        "docs/numerics.md"),
    lobe_row<lobe::cosine_quadratic>("max(0, (n + 1)/3 (c - 1) + 1)^2", "[T] (2.15)"),
    lobe_row<lobe::cosine_quadratic_energy>("(n + 6)/24.55 max(0, (n + 1)/3 (c - 1) + 1)^2", "[T] (2.26)"),
    lobe_row<lobe::cosine_quadratic_energy_safe>("(n + 1)/(8 pi) max(0, (n + 1)/3 (c - 1) + 1)^2",
                                                 "docs/numerics.md"),
    lobe_row<lobe::lyon_2>("max(0, 1 - n (1 - c)/2)^2", "Lyon, Apple TR 43"),
    lobe_row<lobe::lyon_4>("max(0, 1 - n (1 - c)/4)^4", "Lyon, Apple TR 43"),
    lobe_row<lobe::lyon_8>("max(0, 1 - n (1 - c)/8)^8", "Lyon, Apple TR 43"),
    lobe_row<lobe::gx>("c^2 / (n/2 + (1 - n/2) c^2)", "GameCube GX lighting"),
    lobe_row<lobe::rational>("max(0, 1 - r u) / (1 - r u + s u), u = 1 - c, r and s by n",
                             "docs/numerics.md"),
    model{"schlick-modified-e", "n,a,cos", "cos^a / (n - n cos + cos)", "[T] table 3.2",
          checked_schlick_power},
    model{"coefficient-exact", "n", "a = (t^(n-1) - 1)/(t - 1), t = sqrt((n-1)/n); 0 at n = 1", "[P] (9)",
          checked_coefficient<coefficient_line::exact>},
    model{"coefficient-published", "n", "a = 0.786 n + 0.5", "[P] (10)",
          checked_coefficient<coefficient_line::published>},
    model{"coefficient-derived", "n", "a = 2 (1 - e^(-1/2)) n - 1/2", "[P] (9) expanded",
          checked_coefficient<coefficient_line::derived>},
    model{"angle", "n,k,q,x", "cos^k(acos(q^(1/k)) / acos(q^(1/n)) x), zero from the root on",
          "[A], 4th formula", checked_angle},
    model{"angle-limit", "n,k,q", "gran = pi/2 acos(q^(1/n)) / acos(q^(1/k)), radians", "[A], gran",
          checked_level<limit_of>},
    model{"angle-integral", "n,k,q",
          "Int = integral from 0 to gran of cos^k(acos(q^(1/k)) / acos(q^(1/n)) x) cos x sin x dx",
          "[A], Int", checked_level<integral_of>},
    model{"angle-coef-exact", "n,k,q", "1 / (2 pi Int(n, k, q))", "[A], coef", checked_level<coefficient_of>},
    model{"angle-coef-safe", "n,k,q",
          "1 / (8 pi integral from 0 to gran of cos^k(acos(q^(1/k)) / acos(q^(1/n)) x) sin x dx)",
          "docs/numerics.md", checked_level<safe_coefficient_of>},
    model{"angle-coef-fitted", "n,k,q",
          "0.608 n (q - 0.193)/(2 q + 2 k) + 0.161 n + 0.284, or 0.743 q (0.167 n - 0.0133 k n)/k + 0.167 n "
          "+ 0.245",
          "[A], fitted coef", checked_angle_coefficient_fitted},
    model{"lambert", "ia,il,ka,kd,nx,ny,nz,lx,ly,lz", "ia ka + il kd max(0, N.L)", "[T] (1.2) diffuse",
          checked_lambert},
    model{"phong", "n,ia,il,ka,kd,ks,nx,ny,nz,lx,ly,lz,vx,vy,vz",
          "ia ka + il (kd max(0, N.L) + ks max(0, R.V)^n), R = 2 (N.L) N - L; no ks behind the surface",
          "[T] (1.2) (2.9)", checked_phong},
    model{"blinn-shading", "n,ia,il,ka,kd,ks,nx,ny,nz,lx,ly,lz,vx,vy,vz",
          "ia ka + il (kd max(0, N.L) + ks max(0, N.H)^n), H = (L + V)/|L + V|; no ks behind the surface",
          "[P] (1), [T] (2.11)", checked_blinn_shading},
    model{"half-vector-cosine", "nx,ny,nz,lx,ly,lz,vx,vy,vz",
          "max(0, N.H), H = (L + V)/|L + V|, 0 where L + V = 0", "[P] (2), [A]", checked_half_cosine},
    model{"mirror-cosine", "nx,ny,nz,lx,ly,lz,vx,vy,vz", "max(0, R.V), R = 2 (L.N) N - L", "[T] (2.10)",
          checked_mirror_cosine},
    model{"fresnel", "index,vh",
          "F = ((g - c)/(g + c))^2 (1 + ((c (g + c) - 1)/(c (g - c) + 1))^2)/2, c = vh, g^2 = index^2 + c^2 "
          "- 1",
          "[T] (1.4), Cook and Torrance 1982", checked_fresnel},
    model{"facets-gaussian", "m,nh", "D = exp(-(acos(nh)/m)^2)", "[T] (1.4)",
          checked_facets<facet_distribution::gaussian>},
    model{"facets-beckmann", "m,nh", "D = exp(-(1/nh^2 - 1)/m^2) / (m^2 nh^4)", "[T] (1.4)",
          checked_facets<facet_distribution::beckmann>},
    model{"shadowing", "nh,vh,nl,nv", "G/(N.V) = min(1, 2 nh nv/vh, 2 nh nl/vh) / nv", "[T] (1.4)",
          checked_shadowing},
    model{"cook-torrance-gaussian", "m,index,nx,ny,nz,lx,ly,lz,vx,vy,vz", "F D G/(N.V), D Gaussian",
          "[T] (1.4)", checked_cook_torrance<facet_distribution::gaussian>},
    model{"cook-torrance-beckmann", "m,index,nx,ny,nz,lx,ly,lz,vx,vy,vz", "F D G/(N.V), D of Beckmann",
          "[T] (1.4)", checked_cook_torrance<facet_distribution::beckmann>},
    model{"cook-torrance-gaussian-cosines", "m,index,nh,vh,nl,nv", "F D G/(N.V), D Gaussian", "[T] (1.4)",
          checked_cook_torrance_cosines<facet_distribution::gaussian>},
    model{"cook-torrance-beckmann-cosines", "m,index,nh,vh,nl,nv", "F D G/(N.V), D of Beckmann", "[T] (1.4)",
          checked_cook_torrance_cosines<facet_distribution::beckmann>},
    model{"cook-torrance-gaussian-mixed", "s,m,index,nx,ny,nz,lx,ly,lz,vx,vy,vz",
          "s F D G/(N.V) + (1 - s) max(0, N.L), D Gaussian", "[T] (1.3) (1.4)",
          checked_cook_torrance_mixed<facet_distribution::gaussian>},
    model{"cook-torrance-beckmann-mixed", "s,m,index,nx,ny,nz,lx,ly,lz,vx,vy,vz",
          "s F D G/(N.V) + (1 - s) max(0, N.L), D of Beckmann", "[T] (1.3) (1.4)",
          checked_cook_torrance_mixed<facet_distribution::beckmann>},
    model{"reciprocal-shifts", "k,steps", "sum of i_j 2^-j, j = 1..steps, nearest to 1/k", "[T] (2.18)",
          checked_reciprocal},
    model{"shift-division", "difference,k,steps", "difference times the sum of i_j 2^-j nearest to 1/k",
          "[T] (2.18) (2.19)", checked_shift_division},
    model{"angle-reflectance", "n,k,q,incidence",
          "R of angle, x from the half vector to the normal; incidence in degrees", "[A], [T] (2.22)",
          checked_angle_reflectance<lobe_axis::half_vector>},
    model{"angle-reflectance-mirror", "n,k,q,incidence",
          "R of angle, x from the mirror direction, dark beyond 90 degrees; incidence in degrees",
          "[A], [T] (2.22)", checked_angle_reflectance<lobe_axis::mirror>},
    model{"cook-torrance-gaussian-reflectance", "m,index,incidence",
          "R of F D G/(N.V), D Gaussian; incidence in degrees", "[T] (1.4) (2.22)",
          checked_cook_torrance_reflectance<facet_distribution::gaussian>},
    model{"cook-torrance-beckmann-reflectance", "m,index,incidence",
          "R of F D G/(N.V), D of Beckmann; incidence in degrees", "[T] (1.4) (2.22)",
          checked_cook_torrance_reflectance<facet_distribution::beckmann>},
};

/// R of every lobe, around both axes.
template <std::size_t... Index>
constexpr auto reflectance_functions(std::index_sequence<Index...>) {
  return std::array{std::pair{&checked_reflectance<kLobes[Index].which, lobe_axis::half_vector>,
                              &checked_reflectance<kLobes[Index].which, lobe_axis::mirror>}...};
}

/// The single models, and for each lobe its reflectances; the texts that are put together live in `texts`.
std::vector<model> all_models(std::deque<std::string>& texts) {
  std::vector<model> result(kSingleModels.begin(), kSingleModels.end());
  constexpr auto kFunctions = reflectance_functions(std::make_index_sequence<kLobes.size()>());
  for (std::size_t i = 0; i < kLobes.size(); ++i) {
    const std::string name(kLobes[i].name);
    const auto add = [&](const std::string& end, const std::string& axis, double (*value)(inputs_t)) {
      const std::string& full_name = texts.emplace_back(name + end);
      std::string& formula =
          texts.emplace_back("R = integral of max(0, f) cos over the outgoing hemisphere, f = ");
      formula.append(name).append(" of ").append(axis).append("; incidence in degrees");
      result.push_back({full_name, "n,incidence", formula, "[T] (2.22), [A]", value});
    };
    add("-reflectance", "N.H", kFunctions[i].first);
    add("-reflectance-mirror", "max(0, R.V), dark beyond 90 degrees", kFunctions[i].second);
  }
  return result;
}

}  // namespace

std::span<const model> models() {
  static std::deque<std::string> texts;
  static const std::vector<model> all = all_models(texts);
  return all;
}

const model* find_model(std::string_view name) {
  const auto all = models();
  const auto found = std::ranges::find(all, name, &model::name);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace blysk::golden
