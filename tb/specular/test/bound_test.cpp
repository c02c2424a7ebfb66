// SPDX-License-Identifier: Apache-2.0
// The bit-accurate model of a device on parabola_device against its formula, over every input, within the bound of
// docs/architecture.md.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tb/catch.h"
#include "tb/devices/test/asked.h"
#include "tb/inputs.h"
#include "tb/specular/parabola_formula.h"

namespace {

using namespace blysk;
using namespace blysk::specular;

/// A device with its engines and the numbers that the bound needs.
struct subject {
  bool is_clamped;
  int cos_bits, diff_bits;
  std::unique_ptr<engine> bit, golden;
  std::vector<double> a, a_wired;  // by n
  double tightness = 0;
  columns from_bit, from_golden;
};

subject make_subject() {
  const selection asked = blysk::test::asked_for();
  const auto& device = dynamic_cast<const parabola&>(asked.of());
  std::map<std::string, std::string> of_formula = asked.values();
  for (const option& each : device.options()) {
    if (each.is_wired) of_formula.erase(each.name);
  }
  const selection formula = choose(device.name(), asked.format(), of_formula, purpose::formula);
  const word_lengths widths = device.widths(asked);
  subject made{.is_clamped = !asked.flag("as-published"),
               .cos_bits = widths.at("cos"),
               .diff_bits = widths.at("square"),
               .bit = device.make_bit(asked),
               .golden = device.make_golden(formula),
               .a = {},
               .a_wired = {},
               .from_bit = {},
               .from_golden = {}};
  for (int n = 0; n <= 1000; ++n) {
    made.a.push_back(n == 0 ? 0 : device.coefficient(formula, n));
    const auto wired = n == 0 ? 0 : static_cast<double>(device.wired_coefficient(asked, n));
    made.a_wired.push_back(std::ldexp(wired, -widths.at("coefficient")));
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

}  // namespace

TEST_CASE("the bit-accurate model is within its bound for all inputs", "[bound][variants]") {
  subject of = make_subject();
  std::uint64_t inputs = 0;
  for_all_inputs(blysk::test::asked_for(), [&](const columns& writes) {
    check(of, writes);
    inputs += writes.size();
  });
  CHECK(inputs == 1000 * ((std::uint64_t{1} << of.cos_bits) + 1));
  // Rounding alone reaches half an ulp somewhere among so many inputs.
  WARN("largest error / bound: " << of.tightness);
  CHECK(of.tightness > 0.9);
}
