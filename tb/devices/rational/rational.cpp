// SPDX-License-Identifier: Apache-2.0
// The rational lobe as its user meets it: coefficients, formula, bit-accurate model, error bound.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "tb/devices/rational/fit.h"
#include "tb/golden/lobe_formulas.h"
#include "tb/specular/lobe.h"
#include "tb/visit_format.h"

namespace blysk::rational_device {
namespace {

constexpr int kAddresses = 1000;  // exponents

bool is_line(const selection& asked) {
  return asked.value("fit") == "line";
}

double ulp(int fraction) {
  return std::ldexp(1.0, -fraction);
}

/// The lobe (1 - r u)/(1 + d u), u = 1 - c, of an exponent.
struct coefficients {
  double r, d;
};

coefficients of_exponent(bool is_line, double n) {
  if (is_line) return {.r = (n + 3) / 4, .d = n - 1};
  const golden::rational_lobe<double> best(n);
  return {.r = best.r, .d = best.s - best.r};
}

/// (4 - (n + 3) u)/(4 + 4 (n - 1) u), u = 1 - c, 0 beyond its root.
double on_line(double n, double c) {
  const double u = 1 - c;
  return std::max(0.0, 4 - (n + 3) * u) / (4 + 4 * (n - 1) * u);
}

/// Word lengths of a format, from its type.
struct shape {
  int cos_bits, fall_bits, part_bits;
};

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
    const int64_t grounded = 0;
    const int64_t versine = Formats::sub_cos::law(cos_delta);
    const int64_t drop = Formats::mul_fall::law(Formats::fall_of(n), versine);
    const int64_t line = Formats::add_line::law(unity, Formats::inv_drop::law(drop), unity);
    const int64_t climb = Formats::mul_rise::law(Formats::rise_of(n), versine);
    const int64_t divisor = Formats::quant_sum::law(Formats::add_sum::law(unity, climb, grounded));
    return Formats::quant::law(Formats::div::law(Formats::quant_line::law(line), divisor));
  }

  template <class Use>
  static auto in_formats(const selection& asked, Use use) {
    return visit_format(asked.format(), [&]<class Q>() { return with_formats<Q>(asked, use); });
  }
};

class rational final : public specular::device_of_lobe<law> {
 public:
  std::string name() const override { return "rational"; }
  std::string title() const override { return "a quotient of lines in cos(delta), 0 beyond its root"; }
  std::string source() const override { return "own design"; }
  std::string figure() const override { return "UA 60553 fig. 1 with another path"; }
  std::string good_for() const override {
    return "an eighth of Schlick's error with a memory, a fifth without";
  }

  std::vector<option> options() const override {
    return {
        {.name = "fit",
         .help =
             "r and d of (1 - r u)/(1 + d u), u = 1 - c: from memories (best), (n + 3)/4 and n - 1 (line)",
         .values = {"best", "line"},
         .preset = "best"}};
  }

  void check(const selection&) const override {}

  std::string words(const selection& asked) const override {
    return is_line(asked) ? "coefficients (n + 3)/4 and n - 1"
                          : "coefficients from two memories of 1000 words";
  }

  std::int64_t rom_bits(const selection& asked) const override {
    if (is_line(asked)) return 0;
    return law::in_formats(asked, []<class Formats>() {
      return kAddresses * std::int64_t{Formats::fall::width + Formats::rise::width};
    });
  }

  std::string equation(const selection& asked) const override {
    return is_line(asked) ? "BRDF = max(0, 4 - (n + 3) u)/(4 + 4 (n - 1) u), u = 1 - c"
                          : "BRDF = max(0, 1 - r u)/(1 + d u), u = 1 - c, r and d for each n";
  }

  std::function<double(double, double)> formula(const selection& asked) const override {
    if (is_line(asked)) return on_line;
    return golden::rational<double>;
  }

  double root(const selection& asked, double n) const override {
    return std::max(0.0, 1 - 1 / of_exponent(is_line(asked), n).r);
  }

  /// The bound of docs/devices/rational.md.
  std::function<double(double, double)> bound(const selection& asked) const override {
    const bool line = is_line(asked);
    const shape of = law::in_formats(asked, []<class Formats>() {
      return shape{
          .cos_bits = Formats::cos_bits, .fall_bits = Formats::fall_bits, .part_bits = Formats::part_bits};
    });
    return [line, of](double n, double c) {
      // The quotient's rounding, and the formula's own: no digit of r or d is off by more than 2^-44.
      const double rounded = ulp(of.cos_bits + 1) + 512 * std::numeric_limits<double>::epsilon();
      if (line) return rounded;
      const double u = 1 - c;
      const coefficients best = of_exponent(line, n);
      const double part = ulp(of.part_bits + 1) + u * ulp(of.fall_bits + 1);
      const double divisor = 1 + best.d * u;
      const double lobe = std::max(0.0, 1 - best.r * u) / divisor;
      return rounded + part * (1 + lobe) / (divisor - part);
    };
  }
};

}  // namespace

const device& instance() {
  static const rational device;
  return device;
}

}  // namespace blysk::rational_device
