// SPDX-License-Identifier: Apache-2.0
// Lighting from vectors: values worked by hand, and every model in every hard position against itself in 50
// digits. The bound is what running error analysis finds for the model's own steps; what it comes to is stated
// where condition numbers rule it.
#include "tb/golden/scene.h"

#include <cmath>
#include <vector>

#include "tb/catch.h"
#include "tb/golden/running_error.h"

using namespace blysk::golden;

namespace {

template <class Real>
constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();

/// Within so many roundoffs of what was worked by hand.
template <class Real>
bool is(Real computed, double exact, int roundoffs) {
  return std::abs(static_cast<double>(computed) - exact) <=
         roundoffs * std::abs(exact) * static_cast<double>(kEpsilon<Real>) / 2;
}

template <class To, class From>
vec3<To> converted(const vec3<From>& v) {
  return {To(v.x), To(v.y), To(v.z)};
}

template <class To, class From>
illumination<To> converted(const illumination<From>& i) {
  return {To(i.ambient_light), To(i.point_light), To(i.ka), To(i.kd), To(i.ks)};
}

constexpr std::array kDistributions{facet_distribution::gaussian, facet_distribution::beckmann};

/// Up, down, grazing by a spacing and by the smallest normal number, behind by as much, and between.
template <class Real>
std::vector<vec3<Real>> hard_directions() {
  using vec = vec3<Real>;
  const Real tiny = std::numeric_limits<Real>::min();
  return {{0, 0, 1},
          {0, 0, -1},
          {1, 0, 0},
          {-1, 0, 0},
          {1, 0, tiny},
          {-1, 0, tiny},
          {1, 0, kEpsilon<Real>},
          {-1, 0, -kEpsilon<Real>},
          normalised(vec{1, 1, -tiny}),
          normalised(vec{1, 0, Real(1e-3)}),
          normalised(vec{1, 2, 3}),
          normalised(vec{-2, 1, Real(0.5)})};
}

/// The normal along z, where N . L is exact, and one whose products all round.
template <class Real>
std::vector<vec3<Real>> hard_normals() {
  return {{0, 0, 1}, normalised(vec3<Real>{3, -1, 4})};
}

/// Calls use(normal, light, view) for every hard position, its vectors 8 ulp too short, right and 8 ulp too long.
template <class Real, class Use>
void for_each_position(const Use& use) {
  for (const auto& normal : hard_normals<Real>()) {
    for (const auto& light : hard_directions<Real>()) {
      std::vector<vec3<Real>> views = hard_directions<Real>();
      views.push_back(Real(-1) * light);                               // E17
      views.push_back(Real(2) * dot(normal, light) * normal - light);  // the highlight's middle
      for (const auto& view : views) {
        for (const int ulp : {-8, 0, 8}) {
          const Real length = 1 + static_cast<Real>(ulp) * kEpsilon<Real>;
          CAPTURE(normal.x, normal.y, normal.z, light.x, light.y, light.z, view.x, view.y, view.z, ulp);
          use(length * normal, length * light, length * view);
        }
      }
    }
  }
}

/// Positions that were held to the bound, and all.
struct tally {
  int held = 0;
  int all = 0;
};

/// model(number, normal, light, view) computes in the type of `number`. Finite and not negative everywhere; within
/// the bound wherever no comparison lies within its own rounding.
template <class Real, class Model>
void check_position(tally& counts, const Model& model, const vec3<Real>& normal, const vec3<Real>& light,
                    const vec3<Real>& view) {
  const Real value = model(Real(), normal, light, view);
  REQUIRE(std::isfinite(value));
  REQUIRE(value >= 0);
  ++counts.all;
  try {
    using number = bounded<Real>;
    const number exact =
        model(number(), converted<number>(normal), converted<number>(light), converted<number>(view));
    INFO("value " << value << ", exact " << static_cast<double>(exact.value()) << ", bound "
                  << static_cast<double>(exact.error()));
    REQUIRE(abs(referee(value) - exact.value()) <= exact.error());
    ++counts.held;
  } catch (const undecided&) {
  }
}

template <class Real, class Model>
void check_everywhere(const Model& model) {
  tally counts;
  for_each_position<Real>([&](const auto& normal, const auto& light, const auto& view) {
    check_position(counts, model, normal, light, view);
  });
  // The rest grazes: N . L or N . V is zero but for rounding.
  INFO(counts.held << " of " << counts.all << " positions held to the bound");
  CHECK(10 * counts.held >= 8 * counts.all);
}

template <class Real>
constexpr illumination<Real> kLamp{1, 1, Real(0.1), Real(0.6), Real(0.3)};

}  // namespace

TEMPLATE_TEST_CASE("Lambert, Phong and Blinn give what is worked out by hand", "[golden][scene]", float,
                   double) {
  using vec = vec3<TestType>;
  const auto real = [](double x) { return static_cast<TestType>(x); };
  const illumination<TestType> i{2, 4, real(0.5), real(0.25), real(0.5)};
  const vec normal{0, 0, 1};
  const vec light{real(0.6), 0, real(0.8)};
  CHECK(is(lambert(i, normal, light), 1.8, 4));  // 2 * 0.5 + 4 * 0.25 * 0.8
  CHECK(lambert(i, normal, vec{0, real(0.6), real(-0.8)}) == 1);

  // R = (-0.6, 0, 0.8); R . V = 1, then 0.48 + 0.48.
  CHECK(is(phong(i, TestType(2), normal, light, vec{real(-0.6), 0, real(0.8)}), 3.8, 12));
  CHECK(is(phong(i, TestType(2), normal, light, vec{real(-0.8), 0, real(0.6)}), 3.6432, 12));
  CHECK(is(phong(i, TestType(2), normal, light, vec{real(0.6), 0, real(-0.8)}), 1.8, 4));

  // L + V = (0.96, 0, 1.28), H = (0.6, 0, 0.8): 1 + 0.28 + 2 * 0.8^2.
  const vec low{real(0.96), 0, real(0.28)};
  CHECK(is(half_vector_shading(lobe::blinn, i, TestType(2), normal, low, normal), 2.56, 12));
  CHECK(
      is(half_vector_shading(lobe::schlick, i, TestType(3), normal, low, normal), 1.28 + 2 * 0.8 / 1.4, 12));
}

TEMPLATE_TEST_CASE("a direction has unit length whatever the vector's", "[golden][scene]", float, double) {
  using vec = vec3<TestType>;
  using limits = std::numeric_limits<TestType>;
  const auto third = [](double x) { return x / 3; };
  std::vector<TestType> scales{limits::denorm_min(), limits::min(), limits::max() / 4, 1};
  for (int exponent = limits::min_exponent; exponent < limits::max_exponent - 2; exponent += 7)
    scales.push_back(std::ldexp(TestType(1), exponent));
  if (limits::max_exponent > 1000) {
    scales.push_back(static_cast<TestType>(1e-170));
    scales.push_back(static_cast<TestType>(1e160));
  }
  for (const TestType scale : scales) {
    CAPTURE(scale);
    // The components themselves round by a roundoff; dot 3, sqrt 2, quotient and product 2.
    const vec found = normalised(vec{scale, -2 * scale, 2 * scale});
    CHECK(is(found.x, third(1), 8));
    CHECK(is(found.y, third(-2), 8));
    CHECK(is(found.z, third(2), 8));
  }
  // One component that is far below the others, and one whose square alone is infinite.
  CHECK(normalised(vec{limits::denorm_min(), 0, 0}).x == 1);
  CHECK(normalised(vec{limits::max(), 1, 0}).x == 1);
  CHECK(is(normalised(vec{limits::max(), limits::max(), 0}).y, std::sqrt(0.5), 8));
}

TEMPLATE_TEST_CASE("a vector without a direction becomes zero, an infinite one finite", "[golden][scene]",
                   float, double) {
  using vec = vec3<TestType>;
  const TestType nan = std::numeric_limits<TestType>::quiet_NaN();
  const TestType infinite = std::numeric_limits<TestType>::infinity();
  const auto same = [](const vec& a, const vec& b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
  const vec zero{0, 0, 0};
  CHECK(same(normalised(zero), zero));
  CHECK(same(normalised(vec{nan, 0, 1}), zero));
  CHECK(same(normalised(vec{1, infinite, nan}), zero));
  CHECK(same(normalised(vec{0, -infinite, 7}), vec{0, -1, 0}));
  const vec corner = normalised(vec{infinite, 1, -infinite});
  CHECK(is(corner.x, std::sqrt(0.5), 8));
  CHECK(corner.y == 0);
  CHECK(corner.z == -corner.x);
  // A picture has no light there rather than no number.
  const vec light = normalised(vec{1, 2, 3});
  CHECK(lambert(kLamp<TestType>, normalised(vec{nan, nan, nan}), light) ==
        kLamp<TestType>.ambient_light * kLamp<TestType>.ka);
  CHECK(half_vector_shading(lobe::gx, kLamp<TestType>, TestType(1), normalised(vec{nan, 0, 0}), light,
                            light) == kLamp<TestType>.ambient_light * kLamp<TestType>.ka);
}

TEMPLATE_TEST_CASE("Beckmann's D keeps its digits where its exponential leaves the normal numbers",
                   "[golden][scene]", float, double) {
  // exp(-t) below the smallest normal number, over m^2 = 2^-20: the quotient is normal.
  const auto m = static_cast<TestType>(0x1p-10);
  const double lowest = -std::log(static_cast<double>(std::numeric_limits<TestType>::min()));
  for (int i = 1; i <= 40; ++i) {
    const double tan2 = (lowest + i / 8.0) * static_cast<double>(m) * static_cast<double>(m);
    const auto c = static_cast<TestType>(1 / std::sqrt(1 + tan2));
    const referee r = c;
    const referee mm = referee(m) * m;
    const referee exact = exp(referee(1 - 1 / (r * r)) / mm) / (mm * r * r * r * r);
    const TestType found = facets(facet_distribution::beckmann, c, m);
    CAPTURE(i, c, found);
    REQUIRE(found >= std::numeric_limits<TestType>::min());
    // t = tan^2/m^2 is off by 7 roundoffs of itself, which the exponential makes absolute; 11 more.
    const referee t = (1 / (r * r) - 1) / mm;
    CHECK(abs(referee(found) - exact) <= allowed_error<TestType>((7 * t + 11) * exact));
  }
}

TEMPLATE_TEST_CASE("D, F and G of Cook-Torrance give what is worked out by hand", "[golden][scene]", float,
                   double) {
  using vec = vec3<TestType>;
  const auto real = [](double x) { return static_cast<TestType>(x); };
  constexpr double kPi = boost::math::constants::pi<double>();
  // alpha = pi/3, m = 1.  tan^2 alpha = 0.36 / 0.64 = m^2 at m = 3/4.
  CHECK(is(facets(facet_distribution::gaussian, real(0.5), real(1)), std::exp(-kPi * kPi / 9), 32));
  CHECK(
      is(facets(facet_distribution::beckmann, real(0.8), real(0.75)), std::exp(-1) / (0.5625 * 0.4096), 32));
  CHECK(facets(facet_distribution::gaussian, real(1), real(0.25)) == 1);
  CHECK(facets(facet_distribution::beckmann, real(1), real(0.25)) == 16);
  CHECK(facets(facet_distribution::beckmann, real(0), real(0.25)) == 0);

  const TestType index = 1.5;
  CHECK(is(fresnel(real(1), index), 0.04, 32));  // ((1.5 - 1)/(1.5 + 1))^2
  CHECK(fresnel(real(0), index) == 1);
  // g = 1 at c = 0.6: ((1 - 0.6)/1.6)^2 / 2 = 1/32, and (0.96 - 1)/(0.24 + 1) = -1/31.
  CHECK(is(fresnel(real(0.6), std::sqrt(real(1.64))), (1 + 1 / 961.0) / 32, 64));

  // Which of G's three terms is the least, with F and D as above.
  const vec normal{0, 0, 1};
  const vec low{real(0.96), 0, real(0.28)};  // H = (0.6, 0, 0.8) with the normal
  const vec left{real(0.6), 0, real(0.8)};
  const vec right{real(-0.6), 0, real(0.8)};  // H = normal
  for (const auto distribution : kDistributions) {
    const TestType m = real(0.4);
    const auto reflected = [&](const vec& light, const vec& view) {
      return cook_torrance(distribution, m, index, normal, light, view);
    };
    const auto fd = [&](double c, double vh) {
      return fresnel(vh, 1.5) * facets(distribution, c, static_cast<double>(m));
    };
    CHECK(is(reflected(low, normal), fd(0.8, 0.8) * 2 * 0.8 * 0.28 / 0.8, 512));  // masks the light
    CHECK(is(reflected(normal, low), fd(0.8, 0.8) * 2 * 0.8 / 0.8, 512));         // masks the view
    CHECK(is(reflected(left, right), fd(1, 0.8) / 0.8, 512));                     // masks nothing
    CHECK(is(cook_torrance_mixed(real(0.75), distribution, m, index, normal, left, right),
             0.75 * fd(1, 0.8) / 0.8 + 0.25 * 0.8, 512));
    CHECK(cook_torrance(distribution, m, index, normal, left, vec{real(-0.6), 0, real(-0.8)}) == 0);
  }
}

TEMPLATE_TEST_CASE("Lambert and Phong keep their bounds in every position", "[stability][scene]", float,
                   double) {
  check_everywhere<TestType>([](auto number, const auto& normal, const auto& light, const auto&) {
    return lambert(converted<decltype(number)>(kLamp<TestType>), normal, light);
  });
  for (const int n : {1, 2, 1000}) {
    CAPTURE(n);
    check_everywhere<TestType>([n](auto number, const auto& normal, const auto& light, const auto& view) {
      using real = decltype(number);
      return phong(converted<real>(kLamp<TestType>), real(n), normal, light, view);
    });
  }
}

TEMPLATE_TEST_CASE("every lobe lights every position within its bound, finite and not negative",
                   "[stability][scene]", float, double) {
  for (const auto& [which, name] : kLobes) {
    for (const int n : {1, 2, 1000}) {
      CAPTURE(name, n);
      check_everywhere<TestType>(
          [each = which, n](auto number, const auto& normal, const auto& light, const auto& view) {
            using real = decltype(number);
            return half_vector_shading(each, converted<real>(kLamp<TestType>), real(n), normal, light, view);
          });
    }
  }
}

TEMPLATE_TEST_CASE("Cook-Torrance keeps its bound in every position", "[stability][scene]", float, double) {
  for (const auto distribution : kDistributions) {
    for (const TestType m : {TestType(0.05), TestType(0.3), TestType(1)}) {
      for (const TestType index : {TestType(1.001), TestType(1.5), TestType(3)}) {
        CAPTURE(static_cast<int>(distribution), m, index);
        check_everywhere<TestType>([&](auto number, const auto& normal, const auto& light, const auto& view) {
          using real = decltype(number);
          return cook_torrance_mixed(real(TestType(0.75)), distribution, real(m), real(index), normal, light,
                                     view);
        });
      }
    }
  }
}

TEMPLATE_TEST_CASE("the bounds are what the condition numbers make them", "[stability][scene]", float,
                   double) {
  using number = bounded<TestType>;
  const referee unit = roundoff<TestType>();
  const auto normal = hard_normals<TestType>().back();
  for (const auto& light : hard_directions<TestType>()) {
    for (const auto& view : hard_directions<TestType>()) {
      if (!(dot(normal, light) > TestType(0.1) && dot(normal, view) > TestType(0.1))) continue;
      // L + V 1; its square 2 + 3, the root 3.5, 1/|L + V| 4.5, H 6.5; N . H 9.5 of the sum of |N_i H_i| <= 1.
      const number nh = clamped_cosine(converted<number>(normal),
                                       half_vector(converted<number>(light), converted<number>(view)));
      CHECK(nh.error() <= allowed_error<TestType>(referee(10)));
      // d ln(c^n) / dc = n / c;  pow 2.
      for (const int n : {1, 100}) {
        const number power = blinn(number(n), nh);
        CHECK(power.error() <= allowed_error<TestType>((n * 10 / nh.value() + 2) * power.value()));
      }
      // e^x - 1 <= x + x^2 for what reaches an exponential.
      const auto grown = [&](const referee& roundoffs) { return roundoffs * (1 + roundoffs * unit); };
      for (const TestType m : {TestType(0.125), TestType(0.3), TestType(0.6), TestType(1)}) {
        // d ln D / dc = 2 alpha / (m^2 sin alpha);  alpha 6, its square over m^2 15, exp 2.
        const referee& c = nh.value();
        const referee alpha = acos(c);
        const referee m2 = referee(m) * m;
        const number gauss = facets(facet_distribution::gaussian, nh, number(m));
        CHECK(gauss.error() <=
              allowed_error<TestType>(
                  grown(10 * 2 * alpha / (m2 * sin(alpha)) + 15 * alpha * alpha / m2 + 2) * gauss.value()));
        // d ln D / dc = 2 / (m^2 c^3) - 4 / c, of the order tan^2(alpha) / m^2 away from the peak;  tan^2 / m^2 7,
        // the exponential's root 2 and twice, the divisor 5, quotient and product 2. The analysis does not see that
        // the exponent and the divisor share c, so their parts add.
        const number beckmann = facets(facet_distribution::beckmann, nh, number(m));
        if (beckmann.value() < std::numeric_limits<TestType>::min()) continue;
        CHECK(beckmann.error() <= allowed_error<TestType>(grown(10 * (2 / (m2 * c * c * c) + 4 / c) +
                                                                7 * (1 / (c * c) - 1) / m2 + 11) *
                                                          beckmann.value()));
      }
    }
  }
}

TEMPLATE_TEST_CASE("opposite light and view give no highlight and no NaN", "[golden][scene]", float, double) {
  using vec = vec3<TestType>;
  for (const vec& v : {vec{0, 0, 1}, vec{1, 2, 3}, vec{-5, TestType(0.1), TestType(1e-3)}}) {
    const vec light = normalised(v);
    for (const TestType scale : {TestType(-1), TestType(-1) - kEpsilon<TestType>}) {
      const vec half_vec = half_vector(light, scale * light);
      CHECK(dot(half_vec, half_vec) == 0);
      CHECK(dot(light, half_vec) == 0);
    }
  }
  // Both a spacing above the horizon and opposite but for it: lobes that are not 0 at cos = 0 give no light.
  const vec normal{0, 0, 1};
  const vec light{1, 0, kEpsilon<TestType>};
  const vec view{-1, 0, kEpsilon<TestType>};
  for (const auto& [which, name] : kLobes) {
    CAPTURE(name);
    const auto lit = [&](const auto& f) { return highlight(f, normal, light, view); };
    CHECK(with_lobe(which, TestType(1), lit) == 0);
  }
}

TEMPLATE_TEST_CASE("light from behind adds nothing, and a viewer behind sees no highlight",
                   "[stability][scene]", float, double) {
  const auto& lamp = kLamp<TestType>;
  for_each_position<TestType>([&](const auto& normal, const auto& light, const auto& view) {
    if (faces_both(normal, light, view)) return;
    const TestType base = lambert(lamp, normal, light);
    if (!(dot(normal, light) > 0)) REQUIRE(base == lamp.ambient_light * lamp.ka);
    REQUIRE(phong(lamp, TestType(1), normal, light, view) == base);
    REQUIRE(half_vector_shading(lobe::blinn, lamp, TestType(1), normal, light, view) == base);
    REQUIRE(cook_torrance(facet_distribution::gaussian, TestType(1), TestType(1.5), normal, light, view) ==
            0);
  });
}

TEST_CASE("a picture cuts the parabola's negative lobe", "[golden][scene]") {
  // cos(delta) = 1/2 with a = 786.5: the parabola is -196.
  const vec3<double> normal{0, 0, 1};
  const vec3<double> light = normalised(vec3<double>{std::sqrt(3.0), 0.2, 1});
  const vec3<double> view = normalised(vec3<double>{std::sqrt(3.0), -0.2, 1});
  CHECK(quadratic<double>(coefficient_line::published, 1000, 0.5) < -196);
  CHECK(half_vector_shading(lobe::quadratic_published, kLamp<double>, 1000.0, normal, light, view) ==
        lambert(kLamp<double>, normal, light));
}

TEST_CASE("cosines a little outside [0, 1] are cut", "[golden][scene]") {
  const vec3<double> long_one{0, 0, 1 + 1e-15};
  CHECK(clamped_cosine(long_one, long_one) == 1);
  CHECK(clamped_cosine(long_one, -1.0 * long_one) == 0);
}
