// SPDX-License-Identifier: Apache-2.0
// The bit-accurate model of a device against its formula, over every input, within the bound that the device derives.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "tb/catch.h"
#include "tb/devices/test/asked.h"
#include "tb/inputs.h"
#include "tb/specular/specular.h"

namespace {

using namespace blysk;
using namespace blysk::specular;

/// A device with its engines and its bound.
struct subject {
  double ulp;
  std::function<double(double, double)> bound;
  std::unique_ptr<engine> bit, golden;
  double tightness = 0;
  columns from_bit, from_golden;
};

subject make_subject(const selection& asked) {
  const auto& device = dynamic_cast<const device_of_points&>(asked.of());
  std::map<std::string, std::string> of_formula = asked.values();
  for (const option& each : device.options()) {
    if (each.is_wired) of_formula.erase(each.name);
  }
  const selection formula = choose(device.name(), asked.format(), of_formula, purpose::formula);
  return {.ulp = std::ldexp(1.0, -asked.fraction()),
          .bound = device.bound(asked),
          .bit = device.make_bit(asked),
          .golden = device.make_golden(formula),
          .from_bit = {},
          .from_golden = {}};
}

void check(subject& of, const columns& writes) {
  of.bit->run(writes, of.from_bit);
  of.golden->run(writes, of.from_golden);
  const auto* const n = writes[kN].data<std::uint16_t>();
  const double* const golden = of.from_golden[kBrdf].data<double>();
  writes[kCos].visit([&](const auto& codes) {
    of.from_bit[kBrdf].visit([&](const auto& brdf) {
      for (std::size_t i = 0; i < writes.size(); ++i) {
        const double c = static_cast<double>(codes[i]) * of.ulp;
        const double error = std::fabs(static_cast<double>(brdf[i]) * of.ulp - golden[i]);
        const double allowed = of.bound(n[i], c);
        if (!(error <= allowed)) {
          CAPTURE(n[i], codes[i], brdf[i], golden[i], error / of.ulp, allowed / of.ulp);
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
  const selection asked = blysk::test::asked_for();
  subject of = make_subject(asked);
  REQUIRE(of.bound);
  std::uint64_t inputs = 0;
  for_all_inputs(asked, [&](const columns& writes) {
    check(of, writes);
    inputs += writes.size();
  });
  CHECK(inputs == 1000 * ((std::uint64_t{1} << asked.fraction()) + 1));
  // Rounding alone reaches half an ulp somewhere among so many inputs.
  WARN("largest error / bound: " << of.tightness);
  CHECK(of.tightness > 0.9);
}
