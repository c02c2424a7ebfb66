// SPDX-License-Identifier: Apache-2.0
// The ways to drop bits against real numbers, and the models that use them against the devices' formulas on real numbers.
#include "tb/specular/rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tb/catch_text.h"
#include "tb/cost/errors.h"
#include "tb/specular/parabola_formula.h"
#include "tb/specular/specular.h"

namespace {

using namespace blysk;
using specular::rounding;
using real = long double;

/// x in units of 2^-bits, a whole number.
real rounded(real x, int bits, rounding how) {
  const real scaled = std::ldexp(x, bits);
  const real below = std::floor(scaled);
  switch (how) {
    case rounding::nearest:
      return std::floor(scaled + 0.5L);
    case rounding::even:
      return std::nearbyint(scaled);
    case rounding::truncate:
      return below;
    case rounding::jam:
      return scaled != below && std::fmod(below, 2) == 0 ? below + 1 : below;
  }
  return 0;
}

template <rounding How>
void check_law() {
  for (int bits = 0; bits <= 5; ++bits) {
    for (std::int64_t x = -200; x <= 200; ++x) {
      CAPTURE(specular::name_of(How), x, bits);
      const auto expected = static_cast<std::int64_t>(rounded(static_cast<real>(x), -bits, How));
      REQUIRE(specular::drop_bits<How>(x, bits) == expected);
      REQUIRE(specular::drop_bits<How>(x, bits, false) == expected);
      REQUIRE(specular::drop_bits<How>(static_cast<std::int32_t>(x), bits) == expected);
    }
  }
}

struct table {
  std::vector<std::int64_t> brdf;
  int steps;  ///< codes of the cosine, less one
  std::int64_t operator()(int n, int code) const {
    return brdf[static_cast<std::size_t>(n - 1) * (static_cast<std::size_t>(steps) + 1) +
                static_cast<std::size_t>(code)];
  }
};

/// BRDF of the model at n of 1..50 and each code of the cosine, raw.
table results_of(const cost::judged& of) {
  table made{{}, 1 << of.cos_bits};
  const std::unique_ptr<engine> model = of.make();
  columns in(of.stimulus);
  columns out;
  in.resize(static_cast<std::size_t>(made.steps) + 1);
  for (int n = 1; n <= 50; ++n) {
    for (std::size_t i = 0; i < in.size(); ++i) {
      in[specular::kN].set(i, n);
      in[specular::kCos].set(i, static_cast<std::int64_t>(i));
      for (const std::size_t colour : {specular::kRed, specular::kGreen, specular::kBlue})
        in[colour].set(i, 0);
    }
    model->run(in, out);
    for (std::size_t i = 0; i < in.size(); ++i) made.brdf.push_back(out[specular::kBrdf].get(i));
  }
  return made;
}

}  // namespace

TEST_CASE("bits are dropped as each rounding says", "[cost]") {
  check_law<rounding::nearest>();
  check_law<rounding::even>();
  check_law<rounding::truncate>();
  check_law<rounding::jam>();
}

TEST_CASE("half a unit that does not fit is left out", "[cost]") {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  CHECK(specular::drop_bits<rounding::nearest>(kMost, 62, false) == 2);
  CHECK(specular::drop_bits<rounding::even>(kMost, 62) == 2);
  CHECK(specular::drop_bits<rounding::truncate>(kMost, 62) == 1);
  CHECK(specular::drop_bits<rounding::jam>(kMost - 3, 62) == 1);
}

TEST_CASE("a parabola's model rounds its square and its sum in each way", "[cost]") {
  bool was_any = false;
  for (const device* each : devices()) {
    const auto* parabola = dynamic_cast<const specular::parabola*>(each);
    if (parabola == nullptr) continue;
    was_any = true;
    const selection asked = choose(each->name(), "q8");
    word_lengths bits = each->widths(asked);
    const int coefficient_bits = bits.at("coefficient");
    for (const int square_bits : {bits.at("square"), 11, 8}) {
      bits["square"] = square_bits;
      for (const auto& [how, name, what] : specular::kRoundings) {
        const table found = results_of(cost::judge(asked, bits, how));
        for (int n = 1; n <= 50; ++n) {
          const real a =
              std::ldexp(static_cast<real>(parabola->wired_coefficient(asked, n)), -coefficient_bits);
          for (int code = 0; code <= found.steps; ++code) {
            const real c = static_cast<real>(code) / found.steps;
            const real square = std::ldexp(rounded(c * c, square_bits, how), -square_bits);
            const real brdf = rounded(a * (square - c) + c, 8, how);
            CAPTURE(each->name(), square_bits, name, n, code);
            REQUIRE(static_cast<real>(found(n, code)) == std::clamp<real>(brdf, 0, found.steps));
          }
        }
      }
    }
  }
  CHECK(was_any);
}

TEST_CASE("a model that rounds in one way says which do in others", "[cost]") {
  std::vector<const device*> one_way;
  for (const device* each : devices()) {
    const selection asked = choose(each->name(), "q8");
    if (!cost::is_judged(asked)) continue;
    const selection computed = each->computes_as(asked).value_or(asked);
    if (dynamic_cast<const specular::rounded_in_any_way*>(&computed.of()) == nullptr) one_way.push_back(each);
  }
  REQUIRE(!one_way.empty());
  for (const device* each : one_way) {
    const selection asked = choose(each->name(), "q8");
    CHECK_THROWS_WITH(cost::judge(asked, each->widths(asked), rounding::truncate),
                      ContainsSubstring("rounds in one way, expected --rounding nearest or one of "));
  }
}
