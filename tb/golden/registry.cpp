// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/registry.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <string>

#include "tb/golden/angle.h"
#include "tb/golden/lobe.h"

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

template <lobe Which>
double checked_lobe(inputs_t in) {
  require_count(in, 2);
  require_n(in[0]);
  require(in[1] >= 0 && in[1] <= 1, "cos", in[1], "a number in [0, 1]");
  return evaluate(Which, in[0], in[1]) + 0.0;  // the parabola at cos = 0 is -0
}

template <lobe Which>
constexpr model lobe_row(std::string_view formula, std::string_view source) {
  return {name_of(Which), "n,cos", formula, source, checked_lobe<Which>};
}

double checked_angle(inputs_t in) {
  require_count(in, 4);
  require_n(in[0]);
  require_level(in[1], in[2]);
  require(in[3] >= 0 && in[3] <= boost::math::constants::half_pi<double>(), "x", in[3],
          "an angle in [0, pi/2] radians");
  return angle_lobe(in[0], in[1], in[2], in[3]);
}

double checked_angle_coefficient_exact(inputs_t in) {
  require_count(in, 3);
  require_n(in[0]);
  require_level(in[1], in[2]);
  return angle_coefficient_exact(in[0], in[1], in[2]);
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

constexpr std::array kModels{
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
    model{"angle", "n,k,q,x", "cos^k(acos(q^(1/k)) / acos(q^(1/n)) x), zero from the root on",
          "[A], 4th formula", checked_angle},
    model{"angle-coef-exact", "n,k,q", "1 / (2 pi Int(n, k, q))", "[A], coef",
          checked_angle_coefficient_exact},
    model{"angle-coef-fitted", "n,k,q",
          "0.608 n (q - 0.193)/(2 q + 2 k) + 0.161 n + 0.284, or 0.743 q (0.167 n - 0.0133 k n)/k + 0.167 n "
          "+ 0.245",
          "[A], fitted coef", checked_angle_coefficient_fitted},
};

}  // namespace

std::span<const model> models() {
  return kModels;
}

const model* find_model(std::string_view name) {
  const auto found = std::ranges::find(kModels, name, &model::name);
  return found == kModels.end() ? nullptr : &*found;
}

}  // namespace blysk::golden
