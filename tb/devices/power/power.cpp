// SPDX-License-Identifier: Apache-2.0
// The device of cos^n itself as its user meets it: formula, bit-accurate model, error bound.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "tb/devices/power/kernel.h"
#include "tb/golden/lobe_formulas.h"
#include "tb/specular/specular.h"
#include "tb/visit_format.h"

namespace blysk::power_device {
namespace {

double ulp(int fraction) {
  return std::ldexp(1.0, -fraction);
}

/// Word lengths of a format, from its type.
struct shape {
  int cos_bits, ratio_segments, power_segments, word_bits, value_bits, log_bits, place_bits;
};
template <class Formats>
shape shape_in() {
  return {.cos_bits = Formats::cos_bits,
          .ratio_segments = Formats::ratio_segments,
          .power_segments = Formats::power_segments,
          .word_bits = Formats::word_bits,
          .value_bits = Formats::value_bits,
          .log_bits = Formats::log_bits,
          .place_bits = Formats::place_bits};
}

template <class Use>
auto with_formats(const selection& asked, Use use) {
  return visit_format(asked.format(), [&]<class Q>() { return use.template operator()<power_formats<Q>>(); });
}

/// Second derivative of -log2(1 - v/2)/v, which rises with v: the sum of (j-1)(j-2) v^(j-3) / (j 2^j ln 2) from j = 3 on.
double ratio_curvature(double v) {
  double sum = 0;
  for (int j = 60; j >= 3; --j) sum += (j - 1) * (j - 2) * std::pow(v, j - 3) / (j * std::ldexp(1.0, j));
  return sum / std::numbers::ln2;
}

/// How far a line is from a convex curve whose second derivative is at most `most` on the line's segment, of length
/// h = 2^-segments. With D = most h^2/8, and d what the chord is off in the middle, d <= D: the chord is off by at most
/// d t + D t (1 - t) at t/2 and 1 - t/2 of the segment, which is at most (d + D)^2/(4D). The line lies d/2 below the
/// chord, so that it is off by at most (d^2 + D^2)/(4D) <= D/2.
double line_error(int segments, double most) {
  return ulp(2 * segments + 4) * most;
}

/// The bound of docs/devices/power.md.
class error_bound {
 public:
  explicit error_bound(const shape& of) : of_(of), rounding_(ulp(of.word_bits) + ulp(of.value_bits + 1)) {
    const int count = 1 << of.ratio_segments;
    for (int i = 0; i < count; ++i) {
      const double most = ratio_curvature(1 - std::ldexp(i, -of.ratio_segments));
      ratio_error_.push_back(line_error(of.ratio_segments, most) + rounding_);
    }
    // The second derivative of 2^-x is (ln 2)^2 2^-x; x lies no more than a segment above where its segment begins.
    power_error_ = line_error(of.power_segments, std::numbers::ln2 * std::numbers::ln2) *
                   std::exp2(ulp(of.power_segments));
  }

  double operator()(double n, double c) const {
    const double half = ulp(of_.cos_bits + 1);
    if (c == 0) return half;
    // c = 2^-(z+1) (1 + f), 1 - f being 0 at c = 1.
    int exponent = 0;
    const double mantissa = 2 * std::frexp(c, &exponent);
    const double distance = c == 1 ? 0 : 2 - mantissa;
    const auto segment = static_cast<std::size_t>(std::ldexp(mantissa - 1, of_.ratio_segments));
    const double log_error = c == 1 ? 0 : distance * ratio_error_[segment] + ulp(of_.log_bits);
    const double x = -n * std::log2(c);
    const double x_error = n * log_error + ulp(of_.place_bits + 1);
    const double power = golden::blinn<double>(n, c);
    const double error =
        power * (std::expm1(std::numbers::ln2 * x_error) + std::exp2(x_error) * power_error_) +
        std::exp2(-std::floor(std::max(0.0, x - x_error))) * rounding_ + half;
    return error + 4 * std::numeric_limits<double>::epsilon() * power;
  }

 private:
  shape of_;
  double rounding_;  // two words, and what is cut from the line
  std::vector<double> ratio_error_;
  double power_error_;  // of a line for 2^-x, over 2^-x
};

class power final : public specular::device_of_points {
 public:
  std::string name() const override { return "power"; }
  std::string title() const override {
    return "cos^n itself, within one output step, by logarithm and power of two";
  }
  std::string source() const override { return "own design"; }
  std::string figure() const override { return "UA 60553 fig. 1 with another path"; }
  std::string good_for() const override { return "cos^n to the last place, for all n"; }
  std::vector<option> options() const override { return {}; }
  void check(const selection&) const override {}

  std::string words(const selection& asked) const override {
    const shape of = with_formats(asked, []<class Formats>() { return shape_in<Formats>(); });
    return fmt::format("{} lines for the logarithm, {} for the power of two", 1 << of.ratio_segments,
                       1 << of.power_segments);
  }

  std::int64_t rom_bits(const selection& asked) const override {
    return with_formats(asked, []<class Formats>() {
      const auto bits = []<class Lines>() {
        return (Lines::index::max + 1) * std::int64_t{Lines::begin::width + Lines::change::width};
      };
      return bits.template operator()<typename Formats::ratios>() +
             bits.template operator()<typename Formats::powers>();
    });
  }

  std::string equation(const selection&) const override { return "BRDF = c^n"; }
  std::function<double(double, double)> formula(const selection&) const override {
    return golden::blinn<double>;
  }

  /// Where cos^n is half a unit of the last place, below which the BRDF is 0 as a rule.
  double root(const selection& asked, double n) const override {
    return std::exp2(-(asked.fraction() + 1) / n);
  }

  std::function<double(double, double)> bound(const selection& asked) const override {
    return error_bound(with_formats(asked, []<class Formats>() { return shape_in<Formats>(); }));
  }

  std::unique_ptr<engine> make_bit(const selection& asked) const override {
    return with_formats(asked, []<class Formats>() {
      return specular::make_kernel_engine<Formats>(
          [](const specular::columns_of<Formats>& io) { compute<Formats>(io); });
    });
  }

  word_lengths widths(const selection& asked) const override { return {{"cos", asked.fraction()}}; }

  std::unique_ptr<engine> make_bit(const selection& asked, const word_lengths& bits) const override {
    specular::check_only_cosine(asked, bits);
    return with_formats(asked, []<class Formats>() {
      return specular::make_free_engine([](const specular::free_columns& io) { compute<Formats>(io); });
    });
  }
};

}  // namespace

const device& instance() {
  static const power device;
  return device;
}

}  // namespace blysk::power_device
