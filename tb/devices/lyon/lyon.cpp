// SPDX-License-Identifier: Apache-2.0
// Lyon's lobe as its user meets it: degree, formula, bit-accurate model, error bound.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "tb/devices/lyon/degree.h"
#include "tb/golden/lobe_formulas.h"
#include "tb/specular/lobe.h"
#include "tb/visit_format.h"

namespace blysk::lyon_device {
namespace {

double ulp(int fraction) {
  return std::ldexp(1.0, -fraction);
}

int degree(const selection& asked) {
  const std::string& text = asked.value("degree");
  int k = 0;
  std::from_chars(text.data(), text.data() + text.size(), k);
  return k;
}

/// The arithmetic, in the formats of what is asked for.
struct law {
  /// From registers 1 and 2 to the BRDF.
  /// \param n          code of register 1
  /// \param cos_delta  raw, 0..2^F; beyond, the result is unspecified
  /// \return           BRDF, raw
  template <class Formats>
  [[gnu::always_inline]] static std::int64_t brdf(std::int64_t n, std::int64_t cos_delta) {
    using std::int64_t;
    const int64_t unity = 1;
    const int64_t versine = Formats::add_cos::law(unity, Formats::inv_cos::law(cos_delta), unity);
    const int64_t drop = Formats::mul_n::law(Formats::part_n::law(n), versine);
    const int64_t line = Formats::add_line::law(unity, Formats::inv_drop::law(drop), unity);
    const int64_t root = Formats::quant_line::law(line);
    int64_t power = Formats::first_square::law(root, root);
    if constexpr (Formats::squarings == 3) power = Formats::next_square::law(power, power);
    if constexpr (Formats::squarings > 1) power = Formats::last_square::law(power, power);
    return power;
  }

  template <class Use>
  static auto in_formats(const selection& asked, Use use) {
    return visit_format(asked.format(), [&]<class Q>() { return with_formats<Q>(asked, use); });
  }
};

class lyon final : public specular::device_of_lobe<law> {
 public:
  std::string name() const override { return "lyon"; }
  std::string title() const override { return "a power of a line in cos(delta), 0 beyond its root"; }
  std::string source() const override { return "Lyon, Apple TR 43"; }
  std::string figure() const override { return "UA 60553 fig. 1 with another path"; }
  std::string good_for() const override {
    return "no memory, one to three squares; the higher the degree, the smaller the rms error";
  }

  std::vector<option> options() const override {
    return {{.name = "degree",
             .help = "K of the lobe (1 - n (1 - c)/K)^K",
             .values = {"2", "4", "8"},
             .preset = "4"}};
  }

  std::vector<device_alias> aliases() const override {
    return {{"lyon-2", {{"degree", "2"}}}, {"lyon-4", {{"degree", "4"}}}, {"lyon-8", {{"degree", "8"}}}};
  }

  void check(const selection&) const override {}

  std::string words(const selection& asked) const override { return fmt::format("degree {}", degree(asked)); }

  std::string equation(const selection& asked) const override {
    return fmt::format("BRDF = max(0, 1 - n (1 - c)/{0})^{0}", degree(asked));
  }
  std::function<double(double, double)> formula(const selection& asked) const override {
    if (degree(asked) == 2) return golden::lyon<2, double>;
    if (degree(asked) == 4) return golden::lyon<4, double>;
    return golden::lyon<8, double>;
  }

  double root(const selection& asked, double n) const override {
    return std::max(0.0, 1 - degree(asked) / n);
  }

  /// The line is exact; a square is off by twice what its root is, and by its rounding.
  std::function<double(double, double)> bound(const selection& asked) const override {
    const int k = degree(asked);
    const int f = asked.fraction();
    const int kept = f + lyon_formats<q8, 1>::guard_bits;
    return [k, f, kept](double n, double c) {
      double root = std::max(0.0, 1 - n * (1 - c) / k);
      // The formula's own rounding.
      double error = 4 * std::numeric_limits<double>::epsilon();
      for (int degree = 2; degree <= k; degree *= 2) {
        error = error * (2 * root + error) + ulp((degree == k ? f : kept) + 1);
        root *= root;
      }
      return error;
    };
  }
};

}  // namespace

const device& instance() {
  static const lyon device;
  return device;
}

}  // namespace blysk::lyon_device
