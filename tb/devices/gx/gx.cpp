// SPDX-License-Identifier: Apache-2.0
// GX's lobe as its user meets it: formula, bit-accurate model, error bound.
#include <cmath>
#include <limits>
#include <string>

#include "rtl_sysc/devices/gx/gx.h"
#include "tb/golden/lobe_formulas.h"
#include "tb/specular/lobe.h"
#include "tb/visit_format.h"

namespace blysk::gx_device {
namespace {

/// The arithmetic, in the formats of what is asked for.
struct law {
  /// From registers 1 and 2 to the BRDF.
  /// \param n          code of register 1
  /// \param cos_delta  raw, 0..2^F; beyond, the result is unspecified
  /// \return           BRDF, raw
  template <class Formats>
  [[gnu::always_inline]] static std::int64_t brdf(std::int64_t n, std::int64_t cos_delta) {
    using std::int64_t;
    const int64_t grounded = 0;
    const int64_t square = Formats::mul_cos::law(cos_delta, cos_delta);
    const int64_t drop = Formats::mul_n::law(Formats::halve_n::law(n), Formats::sub_square::law(square));
    const int64_t divisor = Formats::add_divisor::law(drop, square, grounded);
    return Formats::quant::law(Formats::div::law(square, divisor));
  }

  template <class Use>
  static auto in_formats(const selection& asked, Use use) {
    return visit_format(asked.format(), [&]<class Q>() { return use.template operator()<gx_formats<Q>>(); });
  }
};

class gx final : public specular::device_of_lobe<law> {
 public:
  std::string name() const override { return "gx"; }
  std::string title() const override { return "a quotient of parabolas in cos(delta)"; }
  std::string source() const override { return "GameCube GX"; }
  std::string figure() const override { return "UA 60553 fig. 1 with another path"; }
  std::string good_for() const override { return "what hardware shipped; Schlick's skirt, exact at n = 2"; }
  std::vector<option> options() const override { return {}; }
  void check(const selection&) const override {}
  std::string words(const selection&) const override { return "a combinational divider"; }

  std::function<double(double, double)> formula(const selection&) const override {
    return golden::gx<double>;
  }

  std::string equation(const selection&) const override { return "BRDF = c^2 / (c^2 + n (1 - c^2)/2)"; }

  /// It reaches 0 at cos = 0 alone.
  double root(const selection&, double) const override { return 0; }

  /// The bound of docs/devices/gx.md: the quotient rounded to nearest, what the rounded square makes of it, and the
  /// formula's own rounding.
  std::function<double(double, double)> bound(const selection& asked) const override {
    const int fraction = asked.fraction();
    const int square_bits = law::in_formats(asked, []<class Formats>() { return Formats::square_bits; });
    return [fraction, square_bits](double n, double c) {
      const double half = std::ldexp(1.0, -fraction - 1) + 16 * std::numeric_limits<double>::epsilon();
      if (square_bits == 2 * fraction) return half;
      const double moved = std::ldexp(1.0, -square_bits - 1);
      const double divisor = n / 2 * (1 - c) * (1 + c) + c * c - std::fabs(n / 2 - 1) * moved;
      return half + moved * n / 2 / (divisor * divisor);
    };
  }
};

}  // namespace

const device& instance() {
  static const gx device;
  return device;
}

}  // namespace blysk::gx_device
