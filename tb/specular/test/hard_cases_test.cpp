// SPDX-License-Identifier: Apache-2.0
// Hard cases of a device that shades a point: the ends of its inputs, either side of where its lobe ends, and whether the BRDF
// ever falls on the way to the peak.
#include <cmath>
#include <vector>

#include "tb/devices/test/asked.h"
#include "tb/specular/test/bound.h"

namespace {

using namespace blysk;
using namespace blysk::specular;

constexpr std::int64_t kExponents[] = {1, 2, 3, 1000};
constexpr std::int64_t kWhole = 1 << 16;   // lobes of so many codes are tried as a whole, all those of q16
constexpr std::int64_t kWindow = 1 << 12;  // of longer ones, at either end and in the middle

/// The BRDF of one exponent at cosine codes.
std::vector<std::int64_t> brdf_at(const selection& asked, engine& bit, std::int64_t n,
                                  const std::vector<std::int64_t>& codes) {
  columns in(asked.of().ports(asked), port::role::data);
  columns out;
  in.resize(codes.size());
  for (std::size_t i = 0; i < codes.size(); ++i) {
    in[kN].set(i, n);
    in[kCos].set(i, codes[i]);
  }
  bit.run(in, out);
  std::vector<std::int64_t> values;
  for (std::size_t i = 0; i < codes.size(); ++i) values.push_back(out[kBrdf].get(i));
  return values;
}

}  // namespace

TEST_CASE("at cos = 0, 1 and beside the corners the model is within its bound, for every n", "[variants]") {
  const selection asked = blysk::test::asked_for();
  specular::test::bounded of(asked);
  for_corner_inputs(asked, 1, [&](const columns& writes) { of.check(writes); });
  CHECK(of.inputs() >= 1000 * 4);
}

TEST_CASE("n = 1, 2, 3 and 1000 at cos = 0, one code below 1 and 1", "[variants]") {
  const selection asked = blysk::test::asked_for();
  const auto& device = dynamic_cast<const device_of_points&>(asked.of());
  const auto bit = device.make_bit(asked);
  const auto bound = device.bound(asked);
  const auto formula = device.formula(asked);
  REQUIRE(bound);
  const std::int64_t one = std::int64_t{1} << asked.fraction();
  for (const std::int64_t n : kExponents) {
    const std::vector<std::int64_t> codes{0, one - 1, one};
    const std::vector<std::int64_t> values = brdf_at(asked, *bit, n, codes);
    CHECK(values[2] >= values[1]);  // 1 is the peak
    CHECK(values[2] > 0);
    for (std::size_t i = 0; i < codes.size(); ++i) {
      const auto exponent = static_cast<double>(n);
      const double c = std::ldexp(static_cast<double>(codes[i]), -asked.fraction());
      const double value = std::ldexp(static_cast<double>(values[i]), -asked.fraction());
      CAPTURE(n, codes[i], values[i], formula(exponent, c));
      CHECK(std::fabs(value - formula(exponent, c)) <= bound(exponent, c));
    }
  }
}

TEST_CASE("the BRDF never falls as the cosine rises within the lobe", "[variants]") {
  const selection asked = blysk::test::asked_for();
  const auto& device = dynamic_cast<const device_of_points&>(asked.of());
  const auto bit = device.make_bit(asked);
  const std::int64_t one = std::int64_t{1} << asked.fraction();
  std::uint64_t steps = 0;
  std::uint64_t falls = 0;
  for (std::int64_t n = 1; n <= 1000; ++n) {
    const auto root = static_cast<std::int64_t>(
        std::ceil(std::ldexp(device.root(asked, static_cast<double>(n)), asked.fraction())));
    // All of the lobe, or its two ends and its middle.
    std::vector<std::int64_t> starts{root};
    std::int64_t length = one - root;
    if (length > kWhole) {
      length = kWindow;
      starts = {root, (root + one) / 2, one - length};
    }
    for (const std::int64_t start : starts) {
      std::vector<std::int64_t> codes;
      for (std::int64_t code = start; code <= start + length; ++code) codes.push_back(code);
      const std::vector<std::int64_t> values = brdf_at(asked, *bit, n, codes);
      for (std::size_t i = 1; i < values.size(); ++i) {
        ++steps;
        if (values[i] >= values[i - 1]) continue;
        if (++falls <= 10)
          WARN("n = " << n << ", cos = " << codes[i] << ": " << values[i - 1] << " to " << values[i]);
      }
    }
  }
  WARN(steps << " steps, " << falls << " falls");
  CHECK(steps > 1000);
  CHECK(falls == 0);
}
