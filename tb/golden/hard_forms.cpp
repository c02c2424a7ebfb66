// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/hard_forms.h"

#include <cmath>
#include <limits>

#include "tb/golden/angle.h"
#include "tb/golden/naive.h"
#include "tb/golden/running_error.h"
#include "tb/golden/scene.h"

namespace blysk::golden {
namespace {

template <class Real, class Literal, class Stable>
loss loss_at(const Literal& literal, const Stable& stable, double point) {
  const auto x = static_cast<Real>(point);
  if (x == 0) return {};  // a point of the wider type alone
  const bounded<Real> exact = stable(bounded<Real>(x));
  const referee ulp = ulp_of<Real>(exact.value());
  const auto error = [&](Real computed) {
    return std::isfinite(computed) ? static_cast<double>(abs(referee(computed) - exact.value()) / ulp)
                                   : std::numeric_limits<double>::infinity();
  };
  return {error(literal(x)), error(stable(x)), static_cast<double>(exact.error() / ulp)};
}

template <class Literal, class Stable>
hard_form make(const std::array<std::string, 4>& words, std::vector<double> points, Literal literal,
               Stable stable, double predicted_float, double predicted_double) {
  return {words[0],
          words[1],
          words[2],
          words[3],
          std::move(points),
          [=](double x) { return loss_at<float>(literal, stable, x); },
          [=](double x) { return loss_at<double>(literal, stable, x); },
          predicted_float,
          predicted_double};
}

std::vector<double> steps(double first, double last, int count) {
  std::vector<double> result;
  for (int i = 0; i <= count; ++i) result.push_back(first + (last - first) * i / count);
  return result;
}

/// Even in their logarithm.
std::vector<double> powers(double first, double last, int count) {
  std::vector<double> result = steps(std::log(first), std::log(last), count);
  for (double& x : result) x = std::exp(x);
  return result;
}

constexpr double kFloat = 0x1p24;  // 1 / roundoff
constexpr double kDouble = 0x1p53;

std::vector<hard_form> make_forms() {
  // Not dyadic, or products with n would be exact; beside the peak, where lobes are.
  const std::vector<double> beside_peak = steps(0.95, 0.99993, 255);
  const std::vector<double> exponents = steps(2, 1000, 998);
  std::vector<hard_form> result;
  // cos(atan(...)) is off by some spacing below 1, t - 1 = -1/(2n): n roundoffs.
  result.push_back(make(
      {"coefficient", "(t^(n-1) - 1)/(t - 1)", "expm1((n-1) l)/expm1(l), l = ln t", "n"}, exponents,
      [](auto n) { return naive::exact_coefficient(n); }, [](auto n) { return exact_coefficient(n); }, 1000,
      1000));
  // q^(1/n) = 1 - d is off by half a roundoff, its angle relatively by that over 2 d; d = 2^-10 / n.
  result.push_back(make(
      {"level", "acos(q^(1/n))", "2 asin(sqrt(-expm1(ln(q)/n)/2))", "n, q = 1023/1024"}, exponents,
      [](auto n) { return naive::angle_of_level(n, decltype(n)(1023) / 1024); },
      [](auto n) { return angle_of_level(n, decltype(n)(decltype(n)(1023) / 1024)); }, 1000 * 1024 / 4.0,
      1000 * 1024 / 4.0));
  // The library reduces its argument as the stable form does.
  result.push_back(make(
      {"angle", "acos(c)", "2 asin(sqrt((1 - c)/2))", "c"}, beside_peak, [](auto c) { return std::acos(c); },
      [](auto c) { return angle_of_cosine(c); }, 0, 0));
  // n c of 512 to 1023 rounds by 512 roundoffs of 1 at most, and the denominator is near 1.
  result.push_back(make(
      {"schlick", "c/(n - n c + c)", "c/(n (1 - c) + c)", "c, n = 1000"}, beside_peak,
      [](auto c) { return naive::schlick(decltype(c)(1000), c); },
      [](auto c) { return schlick(decltype(c)(1000), c); }, 512, 512));
  const auto modified = [&](char letter, schlick_reading reading, std::string_view literal,
                            std::string_view stable) {
    const std::string name(1, letter);
    result.push_back(make(
        {"schlick_modified_" + name, "c/(" + std::string(literal) + " + n - n c + c)",
         "c/(" + std::string(stable) + " + n (1 - c) + c)", "c, n = 1000"},
        beside_peak, [=](auto c) { return naive::schlick_modified(reading, decltype(c)(1000), c); },
        [=](auto c) { return schlick_modified(reading, decltype(c)(1000), c); }, 512, 512));
  };
  modified('a', schlick_reading::a, "n (1 - c^2)/2", "n (1 - c)(1 + c)/2");
  modified('b', schlick_reading::b, "n (1 - c)^2/2", "n (1 - c)^2/2");
  modified('c', schlick_reading::c, "n (1 - cos(acos(c)^2))/2", "n sin^2(angle^2/2)");
  modified('d', schlick_reading::d, "(n (1 - c))^2/2", "(n (1 - c))^2/2");
  // 499 c^2 rounds twice, by 256 roundoffs of 1 each.
  result.push_back(make(
      {"gx", "c^2/(n/2 + (1 - n/2) c^2)", "c^2/(n/2 (1 - c)(1 + c) + c^2)", "c, n = 1000"}, beside_peak,
      [](auto c) { return naive::gx(decltype(c)(1000), c); }, [](auto c) { return gx(decltype(c)(1000), c); },
      512, 512));
  // 750 c^2 and 749 c round three times, by 512 roundoffs of 1 each; the parabola is 1 at most.
  result.push_back(make(
      {"parabola", "a c^2 + (1 - a) c", "c (1 - a (1 - c))", "c, a = 750, root 0.99867"},
      steps(0.99, 0.99993, 255), [](auto c) { return naive::quadratic(decltype(c)(750), c); },
      [](auto c) { return quadratic(decltype(c)(750), c); }, 1024, 1024));
  // Once y^2/2 is below half a roundoff, cos y is 1 and nothing is left.
  result.push_back(make(
      {"versine", "1 - cos y", "2 sin^2(y/2)", "y"}, powers(1e-9, 1, 200),
      [](auto y) { return naive::versine(y); }, [](auto y) { return versine(y); }, kFloat, kDouble));
  // g - c = 2^-10 at c = 1 is off by the roundoff of g, and is squared.
  result.push_back(make(
      {"fresnel", "F with g - c", "F with (index - 1)(index + 1)/(g + c)", "c, index = 1025/1024"},
      steps(0.003, 0.9997, 255), [](auto c) { return naive::fresnel(c, decltype(c)(1025) / 1024); },
      [](auto c) { return fresnel(c, decltype(c)(decltype(c)(1025) / 1024)); }, 2048, 2048));
  // c^2 is off by half a roundoff, and m^-2 = 256 multiplies what is left of 1 - c^2.
  result.push_back(make(
      {"beckmann", "D with 1 - c^2", "D with (1 - c)(1 + c)", "c, m = 1/16"}, beside_peak,
      [](auto c) { return naive::beckmann(c, decltype(c)(1) / 16); },
      [](auto c) { return facets(facet_distribution::beckmann, c, decltype(c)(decltype(c)(1) / 16)); }, 128,
      128));
  // Below the normal numbers min(...) keeps a few bits or none before N.V divides it.
  std::vector<double> grazing = powers(1.4e-45, 1e-36, 60);
  for (const double x : powers(5e-324, 1e-306, 60)) grazing.push_back(x);
  result.push_back(make(
      {"shadowing", "min(1, 2 N.H N.V/V.H, 2 N.H N.L/V.H)/N.V", "min(1/N.V, 2 N.H/V.H, 2 N.H N.L/(V.H N.V))",
       "N.V, N.H = 5/16, V.H = 7/8, N.L = 1/2"},
      grazing,
      [](auto nv) {
        using real = decltype(nv);
        return naive::shadowing(real(5) / 16, real(7) / 8, real(1) / 2, nv);
      },
      [](auto nv) {
        using real = decltype(nv);
        return shadowing(real(real(5) / 16), real(real(7) / 8), real(real(1) / 2), nv);
      },
      kFloat, kDouble));
  // n ln c, down to the logarithm of the smallest normal number, inherits the roundoff of ln c and adds one.
  result.push_back(make(
      {"power", "exp(n ln c)", "pow(c, n)", "c, n = 1000"}, steps(0.5, 0.9993, 499),
      [](auto c) { return naive::power(decltype(c)(1000), c); },
      [](auto c) { return blinn(decltype(c)(1000), c); }, 87, 692));
  // cos(y) is off by half a roundoff, k times.
  result.push_back(make(
      {"angle_lobe", "cos^k(y)", "exp(k ln(1 - sin^2 y)/2)", "y, k = 1000"}, steps(0.0003, 0.15, 499),
      [](auto y) { return naive::angle_lobe_scaled(decltype(y)(1000), y); },
      [](auto y) { return angle_lobe_scaled(decltype(y)(1000), y); }, 500, 500));
  // c^n has a spacing of the smallest numbers, half of which the factor, 40, multiplies; the product is normal.
  std::vector<double> underflow = steps(0.9130, 0.9165, 350);
  for (const double c : steps(0.4906, 0.4925, 190)) underflow.push_back(c);
  result.push_back(make(
      {"blinn_normalised", "(n + 6)/(8 pi) c^n", "(n + 6)/(8 pi) c^(n/2) c^(n/2)", "c, n = 1000"}, underflow,
      [](auto c) { return naive::blinn_normalised(decltype(c)(1000), c); },
      [](auto c) { return blinn_normalised(decltype(c)(1000), c); }, 40, 40));
  // 0 / 0.
  result.push_back(make(
      {"opposite", "N . (L + V)/|L + V|", "0 where |L + V| is rounding alone", "|L|, V = -L, N = L"}, {1},
      [](auto x) {
        const vec3<decltype(x)> light{x, 0, 0};
        return dot(light, naive::half_vector(light, {-x, 0, 0}));
      },
      [](auto x) {
        const vec3<decltype(x)> light{x, 0, 0};
        return dot(light, half_vector(light, {-x, 0, 0}));
      },
      kFloat, kDouble));
  return result;
}

}  // namespace

loss worst_of(const hard_form& form, const std::function<loss(double)>& at) {
  loss result;
  double stable = 0;
  for (const double x : form.points) {
    const loss here = at(x);
    stable = std::max(stable, here.stable);
    if (result.bound == 0 || here.factor() > result.factor()) result = here;
  }
  result.stable = stable;
  return result;
}

const std::vector<hard_form>& hard_forms() {
  static const std::vector<hard_form> forms = make_forms();
  return forms;
}

int cosine_bits(int n) {
  constexpr double kHalfStep = 1 / 510.0;
  for (int bits = 1;; ++bits) {
    const double scale = std::ldexp(1, bits);
    bool enough = true;
    for (double code = 0; enough && code < scale; ++code) {
      const double exact = std::pow((code + 0.5) / scale, n);
      enough = exact - std::pow(code / scale, n) <= kHalfStep &&
               std::pow((code + 1) / scale, n) - exact <= kHalfStep;
    }
    if (enough) return bits;
  }
}

}  // namespace blysk::golden
