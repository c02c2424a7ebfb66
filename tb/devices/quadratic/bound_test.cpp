// SPDX-License-Identifier: Apache-2.0
// The bit-accurate model against the device's formula, over every input, within the bound of docs/architecture.md.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tb/catch.h"
#include "tb/devices/quadratic/wires.h"
#include "tb/golden/coefficient.h"
#include "tb/inputs.h"
#include "tb/specular/specular.h"

namespace {

using namespace blysk;
using namespace blysk::specular;

/// A choice of options with its engines and the numbers that the bound needs.
struct subject {
  bool is_clamped;
  int cos_bits, diff_bits;
  std::unique_ptr<engine> bit, golden;
  std::vector<double> a, a_wired;  // by n
  double tightness = 0;
  columns from_bit, from_golden;
};

subject make_subject(const std::string& format, const std::string& coefficient,
                     const std::string& as_published) {
  const std::map<std::string, std::string> options{{"coefficient", coefficient},
                                                   {"as-published", as_published}};
  const selection asked = choose("quadratic", format, options);
  const selection formula = choose("quadratic", format, options, purpose::formula);
  const word_lengths widths = asked.of().widths(asked);
  subject made{.is_clamped = !asked.flag("as-published"),
               .cos_bits = widths.at("cos"),
               .diff_bits = widths.at("square"),
               .bit = asked.of().make_bit(asked),
               .golden = formula.of().make_golden(formula),
               .a = {},
               .a_wired = {},
               .from_bit = {},
               .from_golden = {}};
  const auto line =
      coefficient == "published" ? golden::coefficient_line::published : golden::coefficient_line::derived;
  const wired_constants wired = quadratic_device::wires(asked);
  const double slope = std::ldexp(static_cast<double>(wired.slope), -widths.at("coefficient"));
  for (int n = 0; n <= 1000; ++n) {
    made.a.push_back(golden::coefficient<double>(line, n));
    made.a_wired.push_back(slope * n + static_cast<double>(wired.offset) / 2);
  }
  return made;
}

/// |bit - golden| <= coefficient + square + rounding + arithmetic, in units of the BRDF:
///   coefficient  |a_wired - a| (c - c^2); clamped, where the lobe ends at c - c^2 = c / a, also
///                <= 1 - min(a_wired, a) / max(a_wired, a)
///   square       a_wired 2^-(diff_bits + 1), if cos^2 is rounded at all
///   rounding     2^-(F + 1)
///   arithmetic   of the golden function itself: three operations on values up to a, each 2^-53 relative
double bound(const subject& of, double a_wired, double a, double c) {
  double coefficient = std::fabs(a_wired - a) * (c - c * c);
  if (of.is_clamped) coefficient = std::fmin(coefficient, 1 - std::fmin(a_wired, a) / std::fmax(a_wired, a));
  const bool square_is_exact = of.diff_bits == 2 * of.cos_bits;
  const double square = square_is_exact ? 0 : std::ldexp(a_wired, -of.diff_bits - 1);
  return coefficient + square + std::ldexp(1.0, -of.cos_bits - 1) +
         3 * a * std::numeric_limits<double>::epsilon() / 2;
}

void check(subject& of, const columns& writes) {
  of.bit->run(writes, of.from_bit);
  of.golden->run(writes, of.from_golden);
  const double ulp = std::ldexp(1.0, -of.cos_bits);
  const auto* const n = writes[kN].data<std::uint16_t>();
  const double* const golden = of.from_golden[kBrdf].data<double>();
  writes[kCos].visit([&](const auto& codes) {
    of.from_bit[kBrdf].visit([&](const auto& brdf) {
      for (std::size_t i = 0; i < writes.size(); ++i) {
        const double c = static_cast<double>(codes[i]) * ulp;
        const double error = std::fabs(static_cast<double>(brdf[i]) * ulp - golden[i]);
        const double allowed = bound(of, of.a_wired[n[i]], of.a[n[i]], c);
        if (!(error <= allowed)) {
          CAPTURE(n[i], codes[i], brdf[i], golden[i], error / ulp, allowed / ulp);
          FAIL("beyond the bound (errors in ulp)");
        }
        of.tightness = std::max(of.tightness, error / allowed);
      }
    });
  });
  for (std::size_t channel = 0; channel < 3; ++channel) {
    for (std::size_t i = 0; i < writes.size(); i += 97) {
      const std::int64_t expected = of.from_bit[kBrdf].get(i) * writes[kRed + channel].get(i);
      if (of.from_bit[kOutRed + channel].get(i) != expected)
        FAIL("a colour is not the BRDF times its factor");
    }
  }
}

void check_format(const std::string& format) {
  std::vector<subject> subjects;
  for (const char* coefficient : {"derived", "published"}) {
    for (const char* as_published : {"off", "on"})
      subjects.push_back(make_subject(format, coefficient, as_published));
  }
  std::uint64_t inputs = 0;
  for_all_inputs(choose("quadratic", format), [&](const columns& writes) {
    for (subject& each : subjects) check(each, writes);
    inputs += writes.size();
  });
  CHECK(inputs == 1000 * ((std::uint64_t{1} << subjects.front().cos_bits) + 1));
  for (const subject& each : subjects) {
    // Rounding alone reaches half an ulp somewhere among so many inputs.
    WARN("largest error / bound: " << each.tightness);
    CHECK(each.tightness > 0.9);
  }
}

}  // namespace

TEST_CASE("q8 within its bound for all inputs", "[bound]") {
  check_format("q8");
}
TEST_CASE("q10 within its bound for all inputs", "[bound]") {
  check_format("q10");
}
TEST_CASE("q12 within its bound for all inputs", "[bound][full]") {
  check_format("q12");
}
TEST_CASE("q14 within its bound for all inputs", "[bound][full]") {
  check_format("q14");
}
TEST_CASE("q16 within its bound for all inputs", "[bound][full]") {
  check_format("q16");
}
