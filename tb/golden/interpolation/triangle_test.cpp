// SPDX-License-Identifier: Apache-2.0
// The six coefficients against a linear system, solved in 50 digits, and against polynomials that are known beforehand.
#include "tb/golden/interpolation/triangle.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>
#include <cmath>
#include <random>
#include <utility>

#include "tb/catch.h"

namespace {

using namespace blysk::golden;
using real = boost::multiprecision::cpp_bin_float_50;

struct point {
  double x, y;
};

/// Vertices 1, 2, 3 and the middles of the edges 12, 13, 23.
std::array<point, 6> nodes_of(const triangle<double>& t) {
  return {{{0, 0},
           {t.x2, t.y2},
           {t.x3, t.y3},
           {t.x2 / 2, t.y2 / 2},
           {t.x3 / 2, t.y3 / 2},
           {(t.x2 + t.x3) / 2, (t.y2 + t.y3) / 2}}};
}

/// The six equations, by elimination with the largest pivot.
std::array<real, 6> solved(const triangle<double>& t, const std::array<double, 6>& intensities) {
  std::array<std::array<real, 7>, 6> rows;
  const std::array<point, 6> nodes = nodes_of(t);
  for (std::size_t i = 0; i < 6; ++i) {
    const real x = nodes[i].x;
    const real y = nodes[i].y;
    rows[i] = {real(1), y, x, real(y * y), real(x * y), real(x * x), real(intensities[i])};
  }
  for (std::size_t column = 0; column < 6; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < 6; ++row) {
      if (abs(rows[row][column]) > abs(rows[pivot][column])) pivot = row;
    }
    std::swap(rows[column], rows[pivot]);
    REQUIRE(rows[column][column] != 0);
    for (std::size_t row = 0; row < 6; ++row) {
      if (row == column) continue;
      const real factor = rows[row][column] / rows[column][column];
      for (std::size_t i = column; i < 7; ++i) rows[row][i] -= factor * rows[column][i];
    }
  }
  std::array<real, 6> result;
  for (std::size_t i = 0; i < 6; ++i) result[i] = rows[i][6] / rows[i][i];
  return result;
}

std::array<double, 6> numbers(const quadratic_surface<double>& s) {
  return {s.p0, s.p1, s.p2, s.p3, s.p4, s.p5};
}

six_intensities<double> named(const std::array<double, 6>& i) {
  return {i[0], i[1], i[2], i[3], i[4], i[5]};
}

double largest_miss(const quadratic_surface<double>& s, const triangle<double>& t,
                    const std::array<double, 6>& intensities) {
  double miss = 0;
  const std::array<point, 6> nodes = nodes_of(t);
  for (std::size_t i = 0; i < 6; ++i)
    miss = std::max(miss, std::abs(s.at(nodes[i].x, nodes[i].y) - intensities[i]));
  return miss;
}

}  // namespace

TEST_CASE("the coefficients solve the six equations", "[golden]") {
  std::mt19937 random(7);
  const auto code = [&](double low, double high) {
    return std::floor(std::uniform_real_distribution(low, high)(random));
  };
  int tried = 0;
  while (tried < 1000) {
    const triangle<double> t{code(-512, 513), code(-512, 513), code(-512, 513), code(-512, 513)};
    const double area = t.x2 * t.y3 - t.y2 * t.x3;
    if (std::abs(area) < 1) continue;
    ++tried;
    std::array<double, 6> intensities{};
    for (double& each : intensities) each = code(0, 256);
    const std::array<double, 6> got = numbers(surface_through(t, named(intensities)));
    const std::array<real, 6> exact = solved(t, intensities);
    CAPTURE(t.x2, t.y2, t.x3, t.y3);
    // Numerators and denominators are whole and below 2^53, so that all that is rounded is the quotient.
    for (std::size_t i = 0; i < 6; ++i) {
      CAPTURE(i);
      CHECK(std::abs(got[i] - static_cast<double>(exact[i])) <= std::ldexp(std::abs(got[i]), -52));
    }
  }
}

TEST_CASE("a polynomial of the second degree is found again", "[golden]") {
  const quadratic_surface<double> wanted{7, -3, 5, 0.25, -0.5, 0.125};
  const triangle<double> t{16, 8, -8, 24};
  std::array<double, 6> intensities{};
  const std::array<point, 6> nodes = nodes_of(t);
  for (std::size_t i = 0; i < 6; ++i) intensities[i] = wanted.at(nodes[i].x, nodes[i].y);
  const quadratic_surface<double> got = surface_through(t, named(intensities));
  CHECK(numbers(got) == numbers(wanted));
  CHECK(got.first_difference(3, 2) == wanted.at(4, 2) - wanted.at(3, 2));
  CHECK(got.second_difference() == wanted.at(5, 2) - 2 * wanted.at(4, 2) + wanted.at(3, 2));
}

TEST_CASE("a triangle without area is refused", "[golden]") {
  CHECK_THROWS_AS(surface_through(triangle<double>{1, 2, 2, 4}, {}), std::domain_error);
}

TEST_CASE("the listing without its slips is the polynomial, with each of them it is not", "[golden]") {
  const triangle<double> t{8, 4, 4, 8};
  const std::array<double, 6> intensities{40, 80, 60, 200, 120, 180};
  const quadratic_surface<double> right = surface_of_listing(t, named(intensities), {});
  CHECK(largest_miss(right, t, intensities) < 1e-11);
  for (std::size_t i = 0; i < 6; ++i)
    CHECK(numbers(right)[i] == Approx(numbers(surface_through(t, named(intensities)))[i]).epsilon(1e-12));
  CHECK(largest_miss(surface_of_listing(t, named(intensities), {.term = true}), t, intensities) ==
        Approx(3920 / 3.0));
  CHECK(largest_miss(surface_of_listing(t, named(intensities), {.division = true}), t, intensities) ==
        Approx(17600 / 3.0));
  CHECK(largest_miss(surface_of_listing(t, named(intensities), {.blue = true}), t, intensities) ==
        Approx(360));
  // It divides by the height of vertex 2.
  const triangle<double> level{8, 0, 4, 8};
  CHECK(!std::isfinite(surface_of_listing(level, named(intensities), {}).p3));
  CHECK(largest_miss(surface_through(level, named(intensities)), level, intensities) < 1e-11);
}

TEST_CASE("with the means of the vertices at the middles it is the plane of Gouraud", "[golden]") {
  const triangle<double> t{8, 4, 4, 8};
  const six_intensities<double> means{40, 80, 60, 60, 50, 70};
  for (const quadratic_surface<double>& s : {surface_through(t, means), surface_of_listing(t, means, {})}) {
    CHECK(s.p3 == 0);
    CHECK(s.p4 == 0);
    CHECK(s.p5 == 0);
    CHECK(s.at(4, 4) == 60);
  }
}
