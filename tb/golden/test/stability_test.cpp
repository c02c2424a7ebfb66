// SPDX-License-Identifier: Apache-2.0
// Every formula against itself in 50 digits at the very numbers it was given, in float and in double. Bounds
// are counted from the roundings of each formula and the condition numbers that carry them to the result; a
// correctly rounded operation counts 1 roundoff, a library function 2 (glibc states below 1 ulp for all
// used). A roundoff is half an ulp of 1, so b roundoffs of a result are b/2 to b ulp of it.
#include <cmath>
#include <set>
#include <vector>

#include "tb/catch.h"
#include "tb/golden/angle.h"
#include "tb/golden/lobe.h"
#include "tb/golden/running_error.h"

using namespace blysk::golden;

namespace {

referee positive(const referee& x) {
  return x > 0 ? x : referee(0);
}

/// |error| of a(n), in roundoffs.
referee coefficient_bound(coefficient_line line, const referee& n) {
  const referee a = abs(coefficient(line, n));
  switch (line) {
    case coefficient_line::published:
      return 3 * a;  // 0.786, *, +
    case coefficient_line::derived:
      return 3 * coefficient_slope<referee>() * n + a;  // expm1 and * reach S n
    case coefficient_line::exact:
      break;
  }
  // n - 1, 1/m, log1p: 4;  m l: 6, expm1: 8;  expm1(l): 6;  the quotient: 15.
  return 15 * a;
}

/// Error of x^k for an error e of x >= 0, exactly rather than to first order, as x may be 0.
referee power_bound(const referee& x, const referee& e, int k, const referee& unit) {
  return (pow(x + e * unit, k) - pow(x, k)) / unit;
}

/// |error| of a lobe, in roundoffs of size `unit`.
referee lobe_bound(lobe which, const referee& n, const referee& c, const referee& unit) {
  const referee u = 1 - c;
  const referee f = abs(evaluate(which, n, c));
  const auto quadratic_bound = [&](coefficient_line line) {
    // c (1 - a u): 1 - c and the product reach a u, the subtraction and the last product the result.
    const referee a = coefficient(line, n);
    return c * u * (coefficient_bound(line, n) + 2 * a) + 2 * abs(quadratic(a, c));
  };
  const auto cosine_quadratic_bound = [&] {
    // (n+1)/3 (1-c): 4 roundings; the subtraction 1; then the square.
    const referee drop = (n + 1) / 3 * u;
    return power_bound(positive(1 - drop), 4 * drop + abs(1 - drop), 2, unit) + cosine_quadratic(n, c);
  };
  const auto lyon_bound = [&](int k) {
    const referee drop = n * u / k;  // 1-c and the product
    return power_bound(positive(1 - drop), 2 * drop + abs(1 - drop), k, unit) + (k - 1) * f;
  };
  switch (which) {
    case lobe::blinn:
      return 2 * f;  // pow
    case lobe::blinn_normalised:
      return 9 * f;  // n + 6, pi, / 3; c^(n/2) 2, twice; two products
    case lobe::schlick:
      return 4 * f;  // 1-c, *, +, /; no term is negative, so none amplifies
    case lobe::schlick_modified_a:
      return 7 * f;  // term 4, two sums, /
    case lobe::schlick_modified_b:
      return 7 * f;
    case lobe::schlick_modified:
      return 8 * f;  // term 5
    // 1-c 1, sqrt 1.5, asin 1.27 * 1.5 + 2 < 4, gamma^2 9, sin 11, its square and n 24, two sums, /.
    case lobe::schlick_modified_c:
      return 27 * f;
    case lobe::quadratic_exact:
      return quadratic_bound(coefficient_line::exact);
    case lobe::quadratic_published:
      return quadratic_bound(coefficient_line::published);
    case lobe::quadratic_derived:
      return quadratic_bound(coefficient_line::derived);
    case lobe::quadratic_energy_safe: {
      // The factor: 8 roundings at most, and a's error through a condition number below 1.
      const referee a = coefficient(coefficient_line::derived, n);
      const referee factor_bound = 8 + coefficient_bound(coefficient_line::derived, n) / a;
      return (factor_bound + 1) * f + quadratic_energy_factor(a) * quadratic_bound(coefficient_line::derived);
    }
    case lobe::cosine_quadratic:
      return cosine_quadratic_bound();
    case lobe::cosine_quadratic_energy:
      return 4 * f + (n + 6) * 100 / 2455 * cosine_quadratic_bound();
    case lobe::cosine_quadratic_energy_safe:
      return 4 * f + (n + 1) / (8 * boost::math::constants::pi<referee>()) * cosine_quadratic_bound();
    case lobe::lyon_2:
      return lyon_bound(2);
    case lobe::lyon_4:
      return lyon_bound(4);
    case lobe::lyon_8:
      return lyon_bound(8);
    case lobe::gx:
      return 7 * f;  // c^2 1; the other term 4, the sum 5; /
    case lobe::rational:
      break;
  }
  // u_i = -expm1(log(v_i)/n): v_0's rounding through log 1.2, log 2, / 1, expm1 2: 6.2 < 7, and 8 for 1/u_i.
  // With 1/u_0 <= 1.75 n, 1/u_1 <= 1.06 n: s within 8 * 2.81 n / 0.688 + 7 s < 43 n, as s < 1.215 n, and
  // r within 8 * 1.75 n + 0.742 (43 n + 4 s) + r < 60 n, as r <= n.
  const rational_lobe<referee> fit(n);
  const referee numerator = positive(1 - fit.r * u);
  const referee denominator = numerator + fit.s * u;
  const referee numerator_bound = u * (60 * n + 2 * fit.r) + abs(1 - fit.r * u);
  return denominator > 0 ? (fit.s * u * numerator_bound + numerator * u * (43 * n + 2 * fit.s)) /
                                   (denominator * denominator) +
                               2 * f
                         : referee(0);
}

/// |error| of the angle-based lobe, in roundoffs: 22 times the condition number k y tan(y) of cos^k(y), and 2.
/// y: two angles and a quotient 15, the product 16. Below pi/4: sin 2, its square 5, log1p passes 1.45 and adds 2, the
/// product with k/2 11; |ln cos^k| is half the condition number at most, so 16 + 5.5. From there on: half pi itself 1;
/// cos passes sin(y) and adds 2, exactly rather than to first order, as the root is near.
template <class Real>
referee angle_lobe_bound(const referee& n, const referee& k, const referee& q, const referee& x) {
  const referee y = angle_scale(n, k, q) * x;
  const referee exact = angle_lobe(n, k, q, x);
  const referee quarter = boost::math::constants::half_pi<referee>() / 2;
  if (y < quarter * (1 - 32 * roundoff<Real>())) return (22 * k * y * tan(y) + 2) * exact;
  const referee c = positive(cos(y));
  const referee e = (17 * y * abs(sin(y)) + 2 * c) * roundoff<Real>();
  return (pow(c + e, k) - pow(c, k)) / roundoff<Real>() + 2 * exact;
}

template <class Real>
std::vector<Real> hard_exponents() {
  const Real above = std::nextafter(Real(1), Real(2));
  return {1, above, Real(1.5), 2, 3, 10, 100, 170, 999, std::nextafter(Real(1000), Real(0)), 1000};
}

/// The ends, one code below 1 for several widths, subnormal cosines, the inflection point, and the neighbours
/// of every lobe's root.
template <class Real>
std::set<Real> hard_cosines(Real n) {
  std::set<Real> result{0,
                        1,
                        Real(0.1),
                        Real(0.5),
                        std::numeric_limits<Real>::denorm_min(),
                        std::numeric_limits<Real>::min(),
                        std::nextafter(Real(1), Real(0))};
  for (const int bits : {8, 12, 15, 18, 23}) result.insert(1 - std::ldexp(Real(1), -bits));
  std::vector<Real> edges{std::sqrt((n - 1) / n),          1 - 3 / (n + 1), 1 - 2 / n, 1 - 4 / n, 1 - 8 / n,
                          1 - 1 / rational_lobe<Real>(n).r};
  for (const auto line : {coefficient_line::published, coefficient_line::derived, coefficient_line::exact})
    edges.push_back(1 - 1 / coefficient(line, n));
  for (const Real edge : edges) {
    for (const Real c : {std::nextafter(edge, Real(-2)), edge, std::nextafter(edge, Real(2))})
      if (c >= 0 && c <= 1) result.insert(c);
  }
  return result;
}

template <class Real, class Exact>
void check_against(Real computed, const Exact& exact, const referee& roundoffs) {
  const referee error = abs(referee(computed) - exact);
  const auto ulp = [&](const referee& e) { return static_cast<double>(e / ulp_of<Real>(exact)); };
  INFO("error " << ulp(error) << " ulp, allowed " << ulp(allowed_error<Real>(roundoffs)) << " ulp or "
                << static_cast<double>(roundoffs) << " roundoffs");
  REQUIRE(std::isfinite(computed));
  REQUIRE(error <= allowed_error<Real>(roundoffs));
}

bool may_exceed_one(lobe which) {
  return which == lobe::blinn_normalised || which == lobe::quadratic_energy_safe ||
         which == lobe::cosine_quadratic_energy || which == lobe::cosine_quadratic_energy_safe;
}

bool may_be_negative(lobe which) {
  return which == lobe::quadratic_exact || which == lobe::quadratic_published ||
         which == lobe::quadratic_derived;
}

}  // namespace

TEMPLATE_TEST_CASE("every lobe keeps its error bound and range at the hard points", "[stability]", float,
                   double) {
  for (const auto& [which, name] : kLobes) {
    for (const TestType n : hard_exponents<TestType>()) {
      referee previous = 0;
      referee previous_bound = 0;
      bool first = true;
      for (const TestType c : hard_cosines(n)) {
        CAPTURE(name, n, c);
        const TestType value = evaluate(which, n, c);
        const referee bound = lobe_bound(which, referee(n), referee(c), roundoff<TestType>());
        check_against(value, evaluate(which, referee(n), referee(c)), bound);
        if (!may_exceed_one(which)) REQUIRE(value <= 1);
        if (!may_be_negative(which)) {
          REQUIRE(value >= 0);
          // Rising in c, but for the two roundings.
          if (!first) REQUIRE(referee(value) + allowed_error<TestType>(bound + previous_bound) >= previous);
        }
        previous = value;
        previous_bound = bound;
        first = false;
      }
    }
  }
}

TEMPLATE_TEST_CASE("every lobe keeps its stated bound from the peak to where the numbers end", "[stability]",
                   float, double) {
  // Where a factor lifts a lobe that has left the normal numbers, digits were lost before.
  const TestType lowest = -std::log(std::numeric_limits<TestType>::min()) + 30;
  for (const auto& [which, name] : kLobes) {
    for (const TestType n :
         {TestType(1), TestType(2.5), TestType(7), TestType(100), TestType(333), TestType(1000)}) {
      std::vector<TestType> cosines;
      for (int i = 0; i < 120; ++i) {
        const TestType step = static_cast<TestType>(i) / 120;
        cosines.push_back(step);                                     // even in c,
        cosines.push_back(std::exp(-lowest * step / n));             // in ln(c^n),
        cosines.push_back(1 - std::min(TestType(1), 4 / n) * step);  // and in the lobe
      }
      for (const TestType c : cosines) {
        CAPTURE(name, n, c);
        check_against(evaluate(which, n, c), evaluate(which, referee(n), referee(c)),
                      lobe_bound(which, referee(n), referee(c), roundoff<TestType>()));
      }
    }
  }
}

TEMPLATE_TEST_CASE("every lobe that peaks at 1 does so exactly", "[stability]", float, double) {
  for (const auto& [which, name] : kLobes) {
    if (may_exceed_one(which)) continue;
    for (const TestType n : hard_exponents<TestType>()) {
      CAPTURE(name, n);
      CHECK(evaluate(which, n, TestType(1)) == 1);
    }
  }
}

TEMPLATE_TEST_CASE("the coefficient keeps its bound on each line", "[stability]", float, double) {
  for (const auto line : {coefficient_line::published, coefficient_line::derived, coefficient_line::exact}) {
    for (const TestType n : hard_exponents<TestType>()) {
      CAPTURE(static_cast<int>(line), n);
      check_against(coefficient(line, n), coefficient(line, referee(n)), coefficient_bound(line, referee(n)));
    }
    for (int n = 1; n <= 1000; ++n) {
      CAPTURE(static_cast<int>(line), n);
      check_against(coefficient(line, TestType(n)), coefficient(line, referee(n)),
                    coefficient_bound(line, referee(n)));
    }
  }
  CHECK(exact_coefficient(TestType(1)) == 0);
}

TEST_CASE("the derived line is the expansion of the exact coefficient", "[stability]") {
  const referee slope = coefficient_slope<referee>();
  for (int n = 2; n <= 1000000; n *= 2) {
    CAPTURE(n);
    CHECK(abs(exact_coefficient(referee(n)) - coefficient(coefficient_line::derived, referee(n))) <
          referee(1) / n);
  }
  CHECK(abs(slope - referee("0.786938680574733")) < referee("5e-16"));
}

TEST_CASE("a graceful underflow: c^n below the smallest normal number", "[stability]") {
  CHECK(blinn(1000.0F, 0.5F) == 0.0F);
  CHECK(blinn(1000.0, 0.5) == std::ldexp(1.0, -1000));
  CHECK(blinn(140.0F, 0.5F) == std::ldexp(1.0F, -140));  // subnormal in single precision
  // docs/numerics.md: c < 0.9164 at n = 1000.
  CHECK(blinn(1000.0F, 0.9162F) < std::numeric_limits<float>::min());
  CHECK(blinn(1000.0F, 0.9164F) > std::numeric_limits<float>::min());
}

TEMPLATE_TEST_CASE("the angle of a level keeps its bound", "[stability]", float, double) {
  const TestType below_one = std::nextafter(TestType(1), TestType(0));
  for (const TestType n : hard_exponents<TestType>()) {
    for (const TestType q : {std::numeric_limits<TestType>::min(), TestType(1e-6), TestType(0.1),
                             TestType(0.5), TestType(0.9), TestType(0.999), below_one}) {
      CAPTURE(n, q);
      const referee exact = angle_of_level(referee(n), referee(q));
      // log 2, / 1, expm1 2; sqrt halves and adds 1; asin below sqrt(1/2) passes 1.27 and adds 2: 6.5.
      check_against(angle_of_level(n, q), exact, 7 * exact);
    }
  }
}

TEMPLATE_TEST_CASE("the angle-based lobe keeps its bound, also beside its root", "[stability]", float,
                   double) {
  const TestType below_one = std::nextafter(TestType(1), TestType(0));
  const TestType half_pi = boost::math::constants::half_pi<TestType>();
  for (const TestType n : hard_exponents<TestType>()) {
    for (const TestType q : {TestType(1e-6), TestType(0.1), TestType(0.5), TestType(0.9), below_one}) {
      for (const TestType k : {TestType(1), TestType(1.5), TestType(2), TestType(5), TestType(33.3),
                               TestType(999), TestType(1000)}) {
        const TestType root = angle_limit(n, k, q);
        std::vector<TestType> angles{0,
                                     TestType(1e-6),
                                     std::nextafter(root, TestType(0)),
                                     root,
                                     std::nextafter(root, TestType(4)),
                                     half_pi};
        for (int i = 1; i < 24; ++i) angles.push_back(root * static_cast<TestType>(i) / 24);
        for (const TestType x : angles) {
          if (x > half_pi) continue;
          CAPTURE(n, q, k, x);
          const TestType value = angle_lobe(n, k, q, x);
          const referee exact = angle_lobe(referee(n), referee(k), referee(q), referee(x));
          check_against(value, exact,
                        angle_lobe_bound<TestType>(referee(n), referee(k), referee(q), referee(x)));
          REQUIRE(value >= 0);
          REQUIRE(value <= 1);
        }
      }
    }
  }
}

TEMPLATE_TEST_CASE("the exact normalisation keeps its bound, whole k or not", "[stability]", float, double) {
  const TestType below_one = std::nextafter(TestType(1), TestType(0));
  const TestType half_pi = boost::math::constants::half_pi<TestType>();
  for (const TestType n : {TestType(1), TestType(2), TestType(5), TestType(1000)}) {
    for (const TestType q : {TestType(1e-6), TestType(0.1), TestType(0.5), below_one}) {
      for (const TestType k : {TestType(1), TestType(1.0625), TestType(1.5), TestType(2.75), TestType(5),
                               TestType(100.5), TestType(1000)}) {
        CAPTURE(n, q, k);
        const referee exact = angle_coefficient_exact(referee(n), referee(k), referee(q));
        // Condition number of coef to the scale s of the angle, by a central difference.
        const auto scale = static_cast<double>(angle_scale(referee(n), referee(k), referee(q)));
        const auto coef_at = [&](double factor) {
          return scale * factor /
                 angle_moment(double{k}, scale * factor, boost::math::constants::half_pi<double>());
        };
        const double h = 1e-4;
        const double condition = std::abs((coef_at(1 + h) - coef_at(1 - h)) / (2 * h) / coef_at(1));
        // The terms that the rule adds, and by how much their signs cancel.
        int terms = 0;
        boost::math::quadrature::tanh_sinh<TestType> rule;
        const auto size = [&](const TestType& y) {
          ++terms;
          return std::abs(angle_lobe_scaled(k, y) * std::sin(2 * y / static_cast<TestType>(scale)));
        };
        const TestType sizes = rule.integrate(size, TestType(0), half_pi);
        const double cancel = static_cast<double>(sizes) * coef_at(1) / scale;
        // s 15, and the two divisions 2. In each term: y 3 and the power 5.5 times the power's condition number, whose
        // mean is 1 + condition; 2 for the power, 3 for its sine, 3 for weight and products. The rule's own error is
        // the square of the tolerance, 2.
        const double bound =
            15 * condition + 2 + cancel * (8.5 * (1 + condition) + 3 * condition + 8 + 2 + terms);
        check_against(angle_coefficient_exact(n, k, q), exact, bound * abs(exact));
      }
    }
  }
}

TEMPLATE_TEST_CASE("the fitted normalisation keeps its bound", "[stability]", float, double) {
  using number = bounded<TestType>;
  for (const int percent : {10, 20, 30, 40, 50, 60, 70, 80, 90}) {
    const TestType q = static_cast<TestType>(percent) / 100;
    for (const int k : {1, 2, 3, 4, 5}) {
      for (const TestType n : hard_exponents<TestType>()) {
        if (!(n > TestType(k))) continue;
        CAPTURE(q, k, n);
        const number exact = angle_coefficient_fitted(number(n), number(k), number(q));
        const TestType value = angle_coefficient_fitted(n, TestType(k), q);
        REQUIRE(std::isfinite(value));
        REQUIRE(abs(referee(value) - exact.value()) <= exact.error());
        // Of its terms only q - 0.193 can cancel: at q = 0.2 that is 28 times its roundings, 3, and at most 0.7 % of
        // the sum. The products add 10, the sums 2.
        REQUIRE(exact.error() <= allowed_error<TestType>(16 * exact.value()));
      }
    }
  }
}

TEMPLATE_TEST_CASE("the angle of a cosine keeps its bound", "[stability]", float, double) {
  for (const TestType c : hard_cosines<TestType>(1000)) {
    CAPTURE(c);
    const referee exact = angle_of_cosine(referee(c));
    check_against(angle_of_cosine(c), exact, 6 * exact);  // 1-c 1, sqrt 1.5, asin 1.27 * 1.5 + 2
  }
}
