// SPDX-License-Identifier: Apache-2.0
// The bit-accurate model against the golden quadratic, over every input, within the bound of docs/architecture.md.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tb/bit/quadratic.h"
#include "tb/catch.h"
#include "tb/golden/lobe_formulas.h"

namespace {

using namespace blysk;

/// |bit - golden| <= coefficient + square + rounding + arithmetic, in units of the BRDF:
///   coefficient  |a_wired - a| (c - c^2); clamped, where the lobe ends at c - c^2 = c / a, also
///                <= 1 - min(a_wired, a) / max(a_wired, a)
///   square       a_wired 2^-(diff_bits + 1), if cos^2 is rounded at all
///   rounding     2^-(F + 1)
///   arithmetic   of the golden function itself: three operations on values up to a, each 2^-53 relative
template <class F, lobe Lobe>
double bound(double a_wired, double a, double c) {
  double coefficient = std::fabs(a_wired - a) * (c - c * c);
  if (Lobe == lobe::clamped)
    coefficient = std::fmin(coefficient, 1 - std::fmin(a_wired, a) / std::fmax(a_wired, a));
  const bool square_is_exact = F::diff_bits == 2 * F::cos_bits;
  const double square = square_is_exact ? 0 : std::ldexp(a_wired, -F::diff_bits - 1);
  return coefficient + square + std::ldexp(1.0, -F::cos_bits - 1) +
         3 * a * std::numeric_limits<double>::epsilon() / 2;
}

template <class F, lobe Lobe>
void check_all_inputs(golden::coefficient_line line, const wired_constants& wired) {
  constexpr std::int64_t codes = F::cos_delta::max + 1;
  using raw = bit::machine_int<typename F::out>;
  const auto size = static_cast<std::size_t>(codes);
  std::vector<std::uint16_t> n(size);
  std::vector<std::uint32_t> cos_delta(size);
  std::vector<std::uint8_t> white(size, 255);
  std::vector<raw> brdf(size), red(size), green(size), blue(size);
  for (std::size_t code = 0; code < size; ++code) cos_delta[code] = static_cast<std::uint32_t>(code);

  double tightness = 0;
  const double ulp = std::ldexp(1.0, -F::cos_bits);
  const double slope = std::ldexp(static_cast<double>(wired.slope), -F::slope_bits);
  for (int exponent = 1; exponent <= 1000; ++exponent) {
    std::fill(n.begin(), n.end(), static_cast<std::uint16_t>(exponent));
    bit::quadratic_vector<F>(wired, {n.data(), cos_delta.data(), white.data(), white.data(), white.data(),
                                     brdf.data(), red.data(), green.data(), blue.data(), size});
    const double a = golden::coefficient<double>(line, exponent);
    const double a_wired = slope * exponent + static_cast<double>(wired.offset) / 2;
    for (std::size_t code = 0; code < size; ++code) {
      const double c = static_cast<double>(code) * ulp;
      double expected = golden::quadratic<double>(line, exponent, c);
      if (Lobe == lobe::clamped) expected = std::clamp(expected, 0.0, 1.0);
      const double error = std::fabs(static_cast<double>(brdf[code]) * ulp - expected);
      const double allowed = bound<F, Lobe>(a_wired, a, c);
      if (!(error <= allowed) || red[code] != brdf[code] * 255) {
        CAPTURE(exponent, code, brdf[code], expected, error / ulp, allowed / ulp, red[code]);
        FAIL("beyond the bound (errors in ulp), or red is not 255 brdf");
      }
      tightness = std::max(tightness, error / allowed);
    }
  }
  // Rounding alone reaches half an ulp somewhere among so many inputs.
  WARN("largest error / bound: " << tightness);
  CHECK(tightness > 0.9);
}

template <class Q>
void check_format() {
  constexpr int bits = quadratic_formats<Q, lobe::clamped>::slope_bits;
  using golden::coefficient_line;
  check_all_inputs<quadratic_formats<Q, lobe::clamped>, lobe::clamped>(coefficient_line::derived,
                                                                       derived_line(bits));
  check_all_inputs<quadratic_formats<Q, lobe::clamped>, lobe::clamped>(coefficient_line::published,
                                                                       published_line(bits));
  check_all_inputs<quadratic_formats<Q, lobe::as_published>, lobe::as_published>(coefficient_line::derived,
                                                                                 derived_line(bits));
  check_all_inputs<quadratic_formats<Q, lobe::as_published>, lobe::as_published>(coefficient_line::published,
                                                                                 published_line(bits));
}

TEST_CASE("q8 within its bound for all inputs", "[unit][bound]") {
  check_format<q8>();
}
TEST_CASE("q10 within its bound for all inputs", "[unit][bound][full]") {
  check_format<q10>();
}
TEST_CASE("q12 within its bound for all inputs", "[unit][bound][full]") {
  check_format<q12>();
}
TEST_CASE("q14 within its bound for all inputs", "[unit][bound][full]") {
  check_format<q14>();
}
TEST_CASE("q16 within its bound for all inputs", "[unit][bound][full]") {
  check_format<q16>();
}

}  // namespace
