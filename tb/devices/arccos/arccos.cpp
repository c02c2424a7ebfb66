// SPDX-License-Identifier: Apache-2.0
// The arc-cosine unit as its user meets it: formula, bit-accurate model.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rtl_sysc/devices/arccos/formats.h"
#include "tb/device.h"
#include "tb/devices/word_lengths.h"
#include "tb/visit_format.h"

namespace blysk::arccos_device {
namespace {

/// Fraction bits, those of the cosine and two numbers that the laws leave open.
struct widths_of_model {
  int cos;
  int root;      ///< of root and ratio
  int segments;  ///< address bits of the table
  int angle;
};

template <class Q>
widths_of_model bits_of() {
  using formats = arccos_formats<Q>;
  return {formats::cos_bits, formats::root_bits, formats::segment_bits, formats::angle_bits};
}

/// The blocks' laws in the order of the clock edges.
class bit_engine final : public engine {
 public:
  bit_engine(const widths_of_model& bits, storage result)
      : engine({result}), bits_(bits), values_((std::size_t{1} << bits.segments) + 1) {
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = arc_ratio_word(i, bits.segments, bits.root);
  }

 private:
  void compute(const columns& in, columns& out) override {
    out[0].visit([&](auto& angles) {
      using element = typename std::remove_reference_t<decltype(angles)>::value_type;
      for (std::size_t i = 0; i < in.size(); ++i) angles[i] = static_cast<element>(angle(in[0].get(i)));
    });
  }

  std::int64_t angle(std::int64_t cos) const {
    const std::int64_t versine = law::subtract(std::int64_t{1} << bits_.cos, cos);
    std::int64_t rest = versine;
    std::int64_t remainder = 0;
    std::int64_t root = 0;
    for (int digit = 0; digit <= bits_.root; ++digit) {
      const std::int64_t next = law::two_bits(rest, bits_.cos);
      const std::int64_t longer = law::root_digits(next, remainder, root);
      remainder = law::root_remainder(next, remainder, root);
      rest = law::after_two_bits(rest, bits_.cos);
      root = longer;
    }
    return law::mul<std::int64_t>(root, ratio(versine), 2 * bits_.root - bits_.angle);
  }

  std::int64_t ratio(std::int64_t versine) const {
    const int rest_bits = bits_.cos - bits_.segments;
    const auto segment = static_cast<std::size_t>(law::upper_bits(versine, rest_bits));
    if (segment + 1 >= values_.size()) return values_.back();
    const std::int64_t slope = values_[segment + 1] - values_[segment];
    return values_[segment] + law::mul<std::int64_t>(slope, law::lower_bits(versine, rest_bits), rest_bits);
  }

  widths_of_model bits_;
  std::vector<std::int64_t> values_;
};

class formula_engine final : public engine {
 public:
  explicit formula_engine(int cos_bits) : engine({storage::f64}), cos_bits_(cos_bits) {}

 private:
  void compute(const columns& in, columns& out) override {
    double* const angles = out[0].data<double>();
    for (std::size_t i = 0; i < in.size(); ++i) angles[i] = std::acos(std::ldexp(in[0].real(i), -cos_bits_));
  }

  int cos_bits_;
};

class arccos_of final : public device {
 public:
  std::string name() const override { return "arccos"; }
  std::string title() const override { return "the angle of a cosine, by a square root and a table"; }
  std::string source() const override { return "patent UA 60553"; }
  std::string figure() const override { return "its argument against UA 71489"; }
  std::string good_for() const override { return "angles for the device angle where only cosines are known"; }
  std::vector<option> options() const override { return {}; }
  void check(const selection&) const override {}
  std::string words(const selection& asked) const override {
    return fmt::format("{} digits of the root, table of {} words", asked.fraction() + 6,
                       (1 << asked.fraction() / 2) + 1);
  }

  std::unique_ptr<engine> make_bit(const selection& asked) const override {
    return visit_format(asked.format(), []<class Q>() -> std::unique_ptr<engine> {
      using result = typename arccos_formats<Q>::angle;
      return std::make_unique<bit_engine>(bits_of<Q>(), storage_of(result::width, result::is_signed));
    });
  }

  /// Two numbers for each segment's beginning, and for the end.
  std::int64_t rom_bits(const selection& asked) const override {
    return visit_format(asked.format(), []<class Q>() {
      using formats = arccos_formats<Q>;
      std::int64_t slope_bits = 0;
      while (std::int64_t{1} << slope_bits <= formats::contents::slopes[formats::contents::slopes.size() - 2])
        ++slope_bits;
      return static_cast<std::int64_t>(formats::contents::values.size()) *
             (formats::ratio::width + slope_bits);
    });
  }

  word_lengths widths(const selection& asked) const override {
    const widths_of_model bits = visit_format(asked.format(), []<class Q>() { return bits_of<Q>(); });
    return {{"root", bits.root}, {"segments", bits.segments}, {"angle", bits.angle}};
  }

  /// The stimulus keeps the fraction bits of its format.
  std::unique_ptr<engine> make_bit(const selection& asked, const word_lengths& bits) const override {
    widths_of_model chosen = visit_format(asked.format(), []<class Q>() { return bits_of<Q>(); });
    const known_width known[] = {{"root", &chosen.root, asked.fraction() / 2, 30},
                                 {"segments", &chosen.segments, 1, std::min(asked.fraction() - 1, 16)},
                                 {"angle", &chosen.angle, 1, 30}};
    take_widths(bits, known);
    if (chosen.angle > 2 * chosen.root) {
      throw std::invalid_argument(
          fmt::format("word length angle {} is outside its range, expected at most twice root {}",
                      chosen.angle, chosen.root));
    }
    return std::make_unique<bit_engine>(chosen, storage::i64);
  }

  std::unique_ptr<engine> make_golden(const selection& asked) const override {
    return std::make_unique<formula_engine>(asked.fraction());
  }

  std::size_t enumerated() const override { return 1; }

  /// One half, where the root is none of the table's points.
  std::vector<std::int64_t> corners(const selection& asked, std::span<const std::int64_t>) const override {
    return {std::int64_t{1} << (asked.fraction() - 1)};
  }
};

}  // namespace

const device& instance() {
  static const arccos_of device;
  return device;
}

}  // namespace blysk::arccos_device
