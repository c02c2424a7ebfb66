// SPDX-License-Identifier: Apache-2.0
// The memory of 256 lines as its user meets it: formula, bit-accurate model, error bound.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "rtl_sysc/devices/table/formats.h"
#include "tb/specular/lobe.h"
#include "tb/visit_format.h"

namespace blysk::table_device {
namespace {

constexpr int kSegments = 256;
constexpr double kEnd = 8;  // of the lobe, in t

double ulp(int fraction) {
  return std::ldexp(1.0, -fraction);
}

/// t = n u (1 + u/2), u = 1 - c: u + u^2/2 are the first terms of -ln(1 - u).
double power_log(double n, double c) {
  const double u = 1 - c;
  return n * u * (1 + u / 2);
}

/// e^-t, and 0 from t = 8 on.
double decay(double t) {
  return t < kEnd ? std::exp(-t) : 0;
}

/// The lines between the points of decay() at multiples of 1/32.
double line(double t) {
  if (t >= kEnd) return 0;
  const double segment = std::floor(t * kSegments / kEnd);
  const double first = decay(segment * kEnd / kSegments);
  const double last = decay((segment + 1) * kEnd / kSegments);
  return first + (last - first) * (t * kSegments / kEnd - segment);
}

/// The largest slope of the lines from t on to the next segment, without its sign.
double slope(double t) {
  if (t >= kEnd) return 0;
  const double length = kEnd / kSegments;
  const double last = kEnd - length;
  const double here = std::exp(-std::max(0.0, t - length));  // at least as steep as t's own line
  return t + length < last ? here : std::max(here, decay(last) / length);
}

/// Word lengths of a format, from its type.
struct shape {
  int cos_bits, word_bits, place_bits, segment_bits, log_bits;
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
    const int64_t factor = Formats::add_factor::law(unity, Formats::halve_versine::law(versine), grounded);
    const int64_t power_log = Formats::mul_n::law(n, Formats::mul_log::law(versine, factor));
    const int64_t limited = Formats::quant_log::law(power_log);
    const int64_t index = Formats::cut_index::law(limited);
    const int64_t change =
        Formats::mul_place::law(Formats::rom_change::law(1, index), Formats::cut_place::law(limited));
    return Formats::quant::law(Formats::add_line::law(Formats::rom_begin::law(0, index), change, grounded));
  }

  template <class Use>
  static auto in_formats(const selection& asked, Use use) {
    return visit_format(asked.format(),
                        [&]<class Q>() { return use.template operator()<table_formats<Q>>(); });
  }
};

class table final : public specular::device_of_lobe<law> {
 public:
  std::string name() const override { return "table"; }
  std::string title() const override { return "256 lines of e^-t, t nearly -n ln(cos(delta))"; }
  std::string source() const override { return "own design"; }
  std::string figure() const override { return "UA 60553 fig. 1 with another path"; }
  std::string good_for() const override { return "one small memory for all n; close from n = 10 on"; }
  std::vector<option> options() const override { return {}; }
  void check(const selection&) const override {}
  std::string words(const selection&) const override { return "a memory of 256 lines"; }

  std::int64_t rom_bits(const selection& asked) const override {
    return law::in_formats(asked, []<class Formats>() {
      return (Formats::index::max + 1) * std::int64_t{Formats::begin::width + Formats::change::width};
    });
  }

  std::string equation(const selection&) const override {
    return "BRDF = e^-t, 0 from t = 8 on, t = n (1 - c) (1 + (1 - c)/2)";
  }

  std::function<double(double, double)> formula(const selection&) const override {
    return [](double n, double c) { return decay(power_log(n, c)); };
  }

  /// Where t is 8; 0 for n up to 5, which do not get so far.
  double root(const selection&, double n) const override {
    return std::max(0.0, 2 - std::sqrt(1 + 2 * kEnd / n));
  }

  /// The bound of docs/devices/table.md.
  std::function<double(double, double)> bound(const selection& asked) const override {
    const shape of = law::in_formats(asked, []<class Formats>() {
      return shape{.cos_bits = Formats::cos_bits,
                   .word_bits = Formats::word_bits,
                   .place_bits = Formats::place_bits,
                   .segment_bits = Formats::segment_bits,
                   .log_bits = Formats::log_bits};
    });
    return [of](double n, double c) {
      const double t = power_log(n, c);
      const double log_error = of.log_bits > 2 * of.cos_bits ? 0 : n * ulp(of.log_bits + 1);
      const double t_error = log_error + ulp(of.segment_bits + of.place_bits + 1);
      const double moved = t_error * slope(std::max(0.0, t - t_error));
      // The formula's own rounding; it may take t across the end.
      double own = 8 * std::numeric_limits<double>::epsilon();
      if (std::fabs(t - kEnd) < 16 * kEnd * own) own += std::exp(-kEnd);
      return std::fabs(line(t) - decay(t)) + moved + ulp(of.word_bits + 1) + ulp(of.cos_bits + 1) + own;
    };
  }
};

}  // namespace

const device& instance() {
  static const table device;
  return device;
}

}  // namespace blysk::table_device
