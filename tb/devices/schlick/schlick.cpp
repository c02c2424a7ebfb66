// SPDX-License-Identifier: Apache-2.0
// Schlick's lobe as its user meets it: formula, bit-accurate model, error bound.
#include <cmath>
#include <limits>
#include <string>

#include "rtl_sysc/devices/schlick/schlick.h"
#include "tb/golden/lobe_formulas.h"
#include "tb/specular/lobe.h"
#include "tb/visit_format.h"

namespace blysk::schlick_device {
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
    const int64_t unity = 1;
    const int64_t grounded = 0;
    const int64_t versine = Formats::add_cos::law(unity, Formats::inv_cos::law(cos_delta), unity);
    const int64_t drop = Formats::mul_n::law(n, versine);
    const int64_t divisor = Formats::add_divisor::law(drop, cos_delta, grounded);
    return Formats::quant::law(Formats::div::law(cos_delta, divisor));
  }

  template <class Use>
  static auto in_formats(const selection& asked, Use use) {
    return visit_format(asked.format(),
                        [&]<class Q>() { return use.template operator()<schlick_formats<Q>>(); });
  }
};

class schlick final : public specular::device_of_lobe<law> {
 public:
  std::string name() const override { return "schlick"; }
  std::string title() const override { return "a quotient of lines in cos(delta)"; }
  std::string source() const override { return "Schlick 1994"; }
  std::string figure() const override { return "UA 60553 fig. 1 with another path"; }
  std::string good_for() const override { return "one divider instead of a power; the skirt is too wide"; }
  std::vector<option> options() const override { return {}; }
  void check(const selection&) const override {}
  std::string words(const selection&) const override { return "a combinational divider"; }

  std::string equation(const selection&) const override { return "BRDF = c / (n - n c + c)"; }
  std::function<double(double, double)> formula(const selection&) const override {
    return golden::schlick<double>;
  }

  /// It reaches 0 at cos = 0 alone.
  double root(const selection&, double) const override { return 0; }

  /// The quotient rounded to nearest, and the formula's own rounding.
  std::function<double(double, double)> bound(const selection& asked) const override {
    const double error = std::ldexp(1.0, -asked.fraction() - 1) + 8 * std::numeric_limits<double>::epsilon();
    return [error](double, double) { return error; };
  }
};

}  // namespace

const device& instance() {
  static const schlick device;
  return device;
}

}  // namespace blysk::schlick_device
