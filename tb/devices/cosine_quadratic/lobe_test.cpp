// SPDX-License-Identifier: Apache-2.0
// What closes key block 12, seen at the BRDF: the sign of adder 8 ends the lobe at its root, comparator 11 does not.
#include <cmath>
#include <vector>

#include "rtl_sysc/devices/cosine_quadratic/formats.h"
#include "tb/catch.h"
#include "tb/inputs.h"
#include "tb/specular/rounding.h"
#include "tb/specular/specular.h"

namespace {

using namespace blysk;
using namespace blysk::specular;

/// BRDF codes by exponent 0..1000 (0 stays empty) and cosine code.
std::vector<std::vector<std::int64_t>> brdf(const std::string& format,
                                            const std::map<std::string, std::string>& options) {
  const selection asked = choose("cosine-quadratic", format, options);
  const auto model = asked.of().make_bit(asked);
  std::vector<std::vector<std::int64_t>> all(1001);
  columns out;
  for_all_inputs(asked, [&](const columns& writes) {
    model->run(writes, out);
    for (std::size_t i = 0; i < writes.size(); ++i)
      all[static_cast<std::size_t>(writes[kN].get(i))].push_back(out[kBrdf].get(i));
  });
  return all;
}

/// True if c < 1 - 3/(n + 1), in integers: c (n + 1) < (n - 2) one.
bool is_beyond_root(std::size_t n, std::size_t code, int fraction) {
  return static_cast<std::int64_t>(code * (n + 1)) <
         (static_cast<std::int64_t>(n) - 2) * (std::int64_t{1} << fraction);
}

}  // namespace

TEST_CASE("gated by the sign the BRDF is 0 beyond the root, grows up to the peak and is 1 there", "[lobe]") {
  const auto lobe = brdf("q12", {});
  for (std::size_t n = 1; n <= 1000; ++n) {
    REQUIRE(lobe[n].size() == 4097);
    for (std::size_t code = 0; code <= 4096; ++code) {
      CAPTURE(n, code);
      // The word of ROM 33 may move the root by less than a code, where the square is 0 in any case.
      if (is_beyond_root(n, code, 12)) REQUIRE(lobe[n][code] == 0);
      if (code > 0) REQUIRE(lobe[n][code] >= lobe[n][code - 1]);
    }
    REQUIRE(lobe[n][4096] == 4096);
  }
}

TEST_CASE("comparator 11 passes the second lobe from n = 3 on, whatever the limit from n = 5 on", "[lobe]") {
  const auto lobe = brdf("q8", {});
  const auto published = brdf("q8", {{"gating", "published"}});
  for (std::size_t n = 1; n <= 1000; ++n) {
    CAPTURE(n);
    std::size_t passed = 0;
    for (std::size_t code = 0; code <= 256; ++code) {
      if (is_beyond_root(n, code, 8)) {
        passed += published[n][code] > 0 ? 1U : 0U;
      } else {
        // Within the lobe it passes the square or nothing.
        REQUIRE((published[n][code] == lobe[n][code] || published[n][code] == 0));
      }
    }
    CHECK((passed > 0) == (n >= 3));
    // A limit that passes the peak passes c = 0.
    if (n >= 5) CHECK(published[n][0] >= published[n][256]);
    CHECK(published[n][256] == 256);
  }
  CHECK(published[1000][0] == 28331002);  // (85419 * 256 - 2^16)^2 / 2^24, 332.67^2
}

TEST_CASE("constants of an LSB make the square of m c", "[lobe]") {
  const auto published = brdf("q8", {{"constants", "published"}});
  CHECK(published[2][256] == 254);          // (255/256 + 2^-16)^2
  CHECK(published[1000][256] == 28279379);  // (85419 * 255 + 1)^2 / 2^24, of the line with 11 bits
  for (std::size_t n = 1; n <= 1000; ++n) {
    for (std::size_t code = 2; code <= 256; ++code) {
      CAPTURE(n, code);
      REQUIRE(published[n][code] >= published[n][code - 1]);
    }
  }
}

TEST_CASE("an energy factor multiplies the lobe", "[lobe]") {
  const auto lobe = brdf("q12", {});
  for (const char* factor : {"published", "safe"}) {
    const auto scaled = brdf("q12", {{"energy", factor}});
    for (std::size_t n = 1; n <= 1000; ++n) {
      const auto exponent = static_cast<double>(n);
      const double by = *factor == 'p' ? (exponent + 6) / 24.55 : (exponent + 1) / 25.132741228718345;
      for (std::size_t code = 0; code <= 4096; ++code) {
        CAPTURE(n, code);
        // Either is within its bound, less than 1 ulp, of the exact one.
        REQUIRE(std::fabs(static_cast<double>(scaled[n][code]) - by * static_cast<double>(lobe[n][code])) <
                1 + by);
      }
    }
  }
}

TEST_CASE("the model rounds line, square and product in each way", "[lobe]") {
  using real = long double;
  const auto rounded = [](real x, int bits, rounding how) {
    const real scaled = std::ldexp(x, bits);
    const real below = std::floor(scaled);
    real whole = below;
    if (how == rounding::nearest) whole = std::floor(scaled + 0.5L);
    if (how == rounding::even) whole = std::nearbyint(scaled);
    if (how == rounding::jam && scaled != below && std::fmod(below, 2) == 0) whole = below + 1;
    return std::ldexp(whole, -bits);
  };
  const word_lengths bits{{"cos", 7}, {"slope", 5}, {"line", 9}, {"square", 10}, {"factor", 6}};
  const selection asked = choose("cosine-quadratic", "q8", {{"energy", "safe"}});
  const auto& of = dynamic_cast<const rounded_in_any_way&>(asked.of());
  constexpr int kCodes = 129;
  for (const auto& [how, name, what] : kRoundings) {
    const auto model = of.make_rounded(asked, bits, how);
    columns in({storage::u16, storage::u32, storage::u8, storage::u8, storage::u8});
    columns out;
    in.resize(kCodes);
    for (int n = 1; n <= 1000; n += n < 20 ? 1 : 49) {
      for (std::size_t code = 0; code < kCodes; ++code) {
        in[kN].set(code, n);
        in[kCos].set(code, static_cast<std::int64_t>(code));
        for (const std::size_t colour : {kRed, kGreen, kBlue}) in[colour].set(code, 0);
      }
      model->run(in, out);
      const real slope = std::ldexp(static_cast<real>(slope_word(static_cast<std::uint64_t>(n), 5)), -5);
      const real factor =
          std::ldexp(static_cast<real>(safe_factor_word(static_cast<std::uint64_t>(n), 6)), -6);
      for (std::size_t code = 0; code < kCodes; ++code) {
        const real line = slope * (std::ldexp(static_cast<real>(code), -7) - 1) + 1;
        const real limited = std::fmax(-1, std::fmin(1, rounded(line, 9, how)));
        const real square = line < 0 ? 0 : rounded(limited * limited, 10, how);
        CAPTURE(name, n, code);
        REQUIRE(static_cast<real>(out[kBrdf].get(code)) == std::ldexp(rounded(square * factor, 7, how), 7));
      }
    }
  }
}
