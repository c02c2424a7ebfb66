// SPDX-License-Identifier: Apache-2.0
// The device of [T] fig. 3.1 as its user meets it: options, formula, bit-accurate model.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "tb/devices/cosine_quadratic/kernel.h"
#include "tb/devices/cosine_quadratic/kinds.h"
#include "tb/golden/lobe_formulas.h"
#include "tb/specular/specular.h"
#include "tb/visit_format.h"

namespace blysk::cosine_quadratic_device {
namespace {

constexpr int kAddresses = 1001;  // exponents, and 0

double ulp(int fraction) {
  return std::ldexp(1.0, -fraction);
}

/// The line m (c - one) + carry, whose square is the lobe; one and carry are 1, or the last places of their adders.
struct line {
  double one, carry;

  explicit line(const selection& asked)
      : one(weighs_an_lsb(asked) ? ulp(asked.fraction()) : 1),
        carry(weighs_an_lsb(asked) ? ulp(2 * asked.fraction()) : 1) {}

  static double slope(double n) { return (n + 1) / 3; }
  double operator()(double n, double c) const { return slope(n) * (c - one) + carry; }

  /// The c where the line is `value`.
  double at(double n, double value) const { return one + (value - carry) / slope(n); }
};

/// What the word of ROM 9 stands for: c^n at the root.
double limit_of(double n) {
  return n <= 2 ? 0 : golden::blinn<double>(n, (n - 2) / (n + 1));
}

double factor(const selection& asked, double n) {
  const double peak = 1;  // the cosine where the lobe is 1
  if (asked.value("energy") == "published") return golden::cosine_quadratic_energy<double>(n, peak);
  if (asked.value("energy") == "safe") return golden::cosine_quadratic_energy_safe<double>(n, peak);
  return 1;
}

/// The words of the memories with so many fraction bits.
memories words_of(const selection& asked, int slope_bits, int limit_bits, int factor_bits) {
  memories words;
  for (std::uint64_t n = 0; n < kAddresses; ++n) {
    words.slope[n] = slope_word(n, slope_bits);
    words.limit[n] = limit_word(n, limit_bits);
    words.factor[n] =
        factor_of(asked) == 0 ? published_factor_word(n, factor_bits) : safe_factor_word(n, factor_bits);
  }
  return words;
}

/// The word lengths of a format, from its type.
template <class Formats>
free_shape shape_in() {
  return {.cos_bits = Formats::cos_bits,
          .slope_bits = Formats::slope_bits,
          .line_bits = Formats::line_bits,
          .square_bits = Formats::square_bits,
          .limit_bits = Formats::limit_bits,
          .factor_bits = Formats::factor_bits,
          .weight_bits = Formats::weight_bits,
          .is_limited = Formats::is_limited,
          .gates_by_limit = Formats::gate == root_gate::limit,
          .has_factor = Formats::has_factor};
}
free_shape shape_in(const selection& asked) {
  return visit_format(asked.format(), [&]<class Q>() {
    return with_formats<Q>(asked, []<class Formats>() { return shape_in<Formats>(); });
  });
}

constexpr bool is_within(int bits, int low, int high) {
  return low <= bits && bits <= high;
}

/// Whether 64 bits hold every net.
bool fits(const free_shape& shape) {
  const int line_frac = shape.slope_bits + shape.cos_bits;
  return is_within(shape.cos_bits, 1, 30) && is_within(shape.slope_bits, 1, 40) && line_frac <= 52 &&
         is_within(shape.line_bits, 1, std::min(line_frac, shape.is_limited ? 30 : 22)) &&
         is_within(shape.square_bits, shape.cos_bits, 2 * shape.line_bits) &&
         (!shape.gates_by_limit || is_within(shape.limit_bits, 1, 38)) &&
         (!shape.has_factor || is_within(shape.factor_bits, 1, std::min(40, 56 - shape.square_bits)));
}

/// The bound of docs/devices/cosine-quadratic.md, with what depends on n alone in tables.
class error_bound {
 public:
  explicit error_bound(const selection& asked)
      : shape_(shape_in(asked)), line_(asked), factor_error_(ulp(shape_.factor_bits + 1)) {
    if (factor_of(asked) == 1) factor_error_ *= 2;  // rounded down, not to nearest
    for (int n = 0; n < kAddresses; ++n) {
      // A word of ROM 33 is off by nothing or by a third of its last place.
      slope_error_.push_back((n + 1) % 3 == 0 ? 0 : ulp(shape_.slope_bits) / 3);
      limit_.push_back(limit_of(n));
      factor_.push_back(factor(asked, n));
    }
  }

  double operator()(double n, double c) const {
    const auto row = static_cast<std::size_t>(n);
    const double versine = std::fabs(c - line_.one);
    const double line_error = slope_error_[row] * versine + ulp(shape_.line_bits + 1);
    const double line = line_(n, c);
    const double value = shape_.gates_by_limit ? std::fabs(line) : std::max(0.0, line);
    const double square = value * value;
    double error = line_error * (2 * value + line_error) + ulp(shape_.square_bits + 1);
    // Beside the limit, one may be cut off and the other not.
    if (shape_.gates_by_limit && std::fabs(square - limit_[row]) <= error + ulp(shape_.limit_bits + 1))
      error += square;
    if (shape_.has_factor)
      error = factor_[row] * error + factor_error_ * (square + error) + ulp(shape_.cos_bits + 1);
    // The formula's own rounding: fewer than eight operations on numbers up to 1 + m |c - one|, squared.
    const double largest = 1 + line::slope(n) * versine;
    return error + 4 * std::numeric_limits<double>::epsilon() * largest * largest * factor_[row];
  }

 private:
  free_shape shape_;
  line line_;
  double factor_error_;
  std::vector<double> slope_error_, limit_, factor_;
};

class cosine_quadratic final : public specular::device_of_points, public specular::rounded_in_any_way {
 public:
  std::string name() const override { return "cosine-quadratic"; }
  std::string title() const override { return "the square of a line in cos(gamma), 0 beyond its root"; }
  std::string source() const override { return "thesis of Buksha"; }
  std::string figure() const override { return "fig. 3.1"; }
  std::string good_for() const override {
    return "smooth end of the highlight, two fifths of the quadratic's largest error; energy factors";
  }

  std::vector<option> options() const override {
    return {
        {.name = "gating",
         .help = "what zeroes the lobe beyond its root: the sign of adder 8 (sign), comparator 11 and ROM 9 "
                 "(published)",
         .values = {"sign", "published"},
         .preset = "sign"},
        {.name = "constants",
         .help = "what -1 at adder 6 and +1 at adder 8 weigh: 1 (unity), the last place of the adder "
                 "(published)",
         .values = {"unity", "published"},
         .preset = "unity"},
        {.name = "energy",
         .help = "factor of the lobe: 1 (none), (n + 6)/24.55 (published), (n + 1)/(8 pi) (safe)",
         .values = {"none", "published", "safe"},
         .preset = "none"}};
  }

  void check(const selection& asked) const override {
    if (!has_factor(asked) || (!gates_by_limit(asked) && !weighs_an_lsb(asked))) return;
    throw std::invalid_argument(
        fmt::format("--energy {} scales a lobe that ends at its root, expected --gating sign and --constants "
                    "unity with it",
                    asked.value("energy")));
  }

  std::string words(const selection& asked) const override {
    return fmt::format("gated by {}, constants weigh {}{}",
                       gates_by_limit(asked) ? "comparator 11 as published" : "the sign of adder 8",
                       weighs_an_lsb(asked) ? "one LSB as published" : "unity",
                       has_factor(asked) ? fmt::format(", energy factor {}", asked.value("energy")) : "");
  }

  std::int64_t rom_bits(const selection& asked) const override {
    const free_shape shape = shape_in(asked);
    return std::int64_t{kAddresses} *
           (9 + shape.slope_bits + (shape.gates_by_limit ? shape.limit_bits - 4 : 0) +
            (shape.has_factor ? 6 + shape.factor_bits : 0));
  }

  std::string equation(const selection& asked) const override {
    const char* const line =
        weighs_an_lsb(asked) ? "m (c - one last place) + one last place" : "m (c - 1) + 1";
    std::string text = fmt::format("BRDF = ({})^2", line);
    if (asked.value("energy") == "published") text = fmt::format("BRDF = (n + 6)/24.55 ({})^2", line);
    if (asked.value("energy") == "safe") text = fmt::format("BRDF = (n + 1)/(8 pi) ({})^2", line);
    return text +
           (gates_by_limit(asked) ? ", 0 where the square is below c^n at the line's root"
                                  : ", 0 where the line is negative") +
           ", m = (n + 1)/3";
  }

  std::function<double(double, double)> formula(const selection& asked) const override {
    const bool is_preset = !weighs_an_lsb(asked) && !gates_by_limit(asked);
    if (asked.value("energy") == "published") return golden::cosine_quadratic_energy<double>;
    if (asked.value("energy") == "safe") return golden::cosine_quadratic_energy_safe<double>;
    if (is_preset) return golden::cosine_quadratic<double>;
    const line of(asked);
    if (!gates_by_limit(asked)) {
      return [of](double n, double c) {
        const double value = of(n, c);
        return value > 0 ? value * value : 0;
      };
    }
    return [of](double n, double c) {
      const double square = of(n, c) * of(n, c);
      return square < limit_of(n) ? 0 : square;
    };
  }

  double root(const selection& asked, double n) const override {
    return std::clamp(line(asked).at(n, 0), 0.0, 1 - ulp(asked.fraction()));
  }

  /// The root, and where the square crosses the limit.
  std::vector<std::int64_t> corners(const selection& asked,
                                    std::span<const std::int64_t> before) const override {
    const auto n = static_cast<double>(before.front());
    std::vector<std::int64_t> found = device_of_points::corners(asked, before);
    if (!gates_by_limit(asked)) return found;
    for (const double value : {std::sqrt(limit_of(n)), -std::sqrt(limit_of(n))}) {
      const double c = std::clamp(line(asked).at(n, value), 0.0, 1.0);
      found.push_back(std::lround(std::ldexp(c, asked.fraction())));
    }
    return found;
  }

  std::function<double(double, double)> bound(const selection& asked) const override {
    return error_bound(asked);
  }

  std::unique_ptr<engine> make_bit(const selection& asked) const override {
    return visit_format(asked.format(), [&]<class Q>() {
      return with_formats<Q>(asked, [&]<class Formats>() {
        return specular::make_kernel_engine<Formats>(
            [words = words_of(asked, Formats::slope_bits, Formats::limit_bits, Formats::factor_bits)](
                const specular::columns_of<Formats>& io) { compute<Formats>(words, io); });
      });
    });
  }

  word_lengths widths(const selection& asked) const override {
    const free_shape shape = shape_in(asked);
    word_lengths bits{{"cos", shape.cos_bits}, {"slope", shape.slope_bits}, {"line", shape.line_bits}};
    if (shape.gates_by_limit) bits["limit"] = shape.limit_bits;
    if (shape.has_factor) {
      bits["square"] = shape.square_bits;
      bits["factor"] = shape.factor_bits;
    }
    return bits;
  }

  std::unique_ptr<engine> make_bit(const selection& asked, const word_lengths& bits) const override {
    return make_rounded(asked, bits, specular::rounding::nearest);
  }

  std::unique_ptr<engine> make_rounded(const selection& asked, const word_lengths& bits,
                                       specular::rounding how) const override {
    const word_lengths known = widths(asked);
    std::string names;
    std::string values;
    for (const auto& [name, width] : known) {
      names += (names.empty() ? "" : ", ") + name;
      if (!bits.contains(name))
        throw std::invalid_argument(
            fmt::format("word length {} is missing, expected one like {}", name, width));
      values += fmt::format("{}{} {}", values.empty() ? "" : ", ", name, bits.at(name));
    }
    for (const auto& [name, width] : bits) {
      if (!known.contains(name))
        throw std::invalid_argument(fmt::format("word length {} does not exist, expected {}", name, names));
    }
    free_shape shape = shape_in(asked);
    shape.cos_bits = bits.at("cos");
    shape.slope_bits = bits.at("slope");
    shape.line_bits = bits.at("line");
    shape.square_bits = shape.has_factor ? bits.at("square") : shape.cos_bits;
    if (shape.gates_by_limit) shape.limit_bits = bits.at("limit");
    if (shape.has_factor) shape.factor_bits = bits.at("factor");
    if (weighs_an_lsb(asked)) shape.weight_bits = shape.cos_bits;
    shape.how = how;
    if (!fits(shape)) {
      throw std::invalid_argument(fmt::format(
          "word lengths {} do not fit, expected 1 <= cos <= 30, 1 <= slope <= 40, cos + slope <= 52, cos <= "
          "2 "
          "line <= 2 (cos + slope), line <= {}{}{}",
          values, shape.is_limited ? 30 : 22, shape.gates_by_limit ? ", 1 <= limit <= 38" : "",
          shape.has_factor ? ", cos <= square <= 2 line, 1 <= factor <= 40, square + factor <= 56" : ""));
    }
    return specular::make_free_engine(
        [shape, words = words_of(asked, shape.slope_bits, shape.limit_bits, shape.factor_bits)](
            const specular::free_columns& io) { compute(shape, words, io); });
  }
};

}  // namespace

const device& instance() {
  static const cosine_quadratic device;
  return device;
}

}  // namespace blysk::cosine_quadratic_device
