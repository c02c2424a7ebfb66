// SPDX-License-Identifier: Apache-2.0
// The lighting unit as its user meets it: option, formula, bit-accurate model.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "rtl_sysc/devices/lighting/formats.h"
#include "tb/device.h"
#include "tb/devices/word_lengths.h"
#include "tb/visit_format.h"

namespace blysk::lighting_device {
namespace {

constexpr std::size_t kChannels = 3;

/// Columns of the stimulus and of the results, those of red.
enum column : std::size_t {
  kCosine,
  kFirst,
  kAmbient,
  kDiffuse = kAmbient + kChannels,
  kSpecular = kDiffuse + kChannels,
  kEnergy = kSpecular + kChannels
};
enum result : std::size_t { kSum, kPixel = kChannels };

/// Fraction bits.
struct bits_of_model {
  int cosine;  ///< and of the specular terms
  int coefficient;
  int factor;
  int sum;
};

template <class Q>
bits_of_model bits_of() {
  using formats = lighting_formats<Q, true>;
  return {formats::cos_bits, formats::coefficient_bits, formats::factor_bits, formats::sum_bits};
}

/// The blocks' laws in the order of the clock edges: the sums are those of the accumulators.
class bit_engine final : public engine {
 public:
  bit_engine(const bits_of_model& bits, bool has_energy, storage sum, storage pixel)
      : engine({sum, sum, sum, pixel, pixel, pixel}),
        bits_(bits),
        has_energy_(has_energy),
        most_(law::move_up<std::int64_t>(colour::max, bits.sum)) {}

 private:
  void compute(const columns& in, columns& out) override {
    for (std::size_t row = 0; row < in.size(); ++row) {
      for (std::size_t channel = 0; channel < kChannels; ++channel) {
        std::int64_t& sum = sums_[channel];
        const std::int64_t ambient =
            law::rescale(in[kAmbient + channel].get(row), bits_.coefficient, bits_.sum);
        const std::int64_t diffuse = law::mul(in[kDiffuse + channel].get(row), in[kCosine].get(row),
                                              bits_.coefficient + bits_.cosine - bits_.sum);
        const std::int64_t base = law::select(in[kFirst].get(row) != 0, ambient, sum);
        const std::int64_t lit = law::add<std::int64_t>(base, 0, diffuse, 0, 0);
        const std::int64_t bright = law::add<std::int64_t>(lit, 0, specular(in, row, channel), 0, 0);
        sum = law::smaller(bright, most_);
        out[kSum + channel].set(row, sum);
        out[kPixel + channel].set(row, law::round_off(sum, bits_.sum));
      }
    }
  }

  std::int64_t specular(const columns& in, std::size_t row, std::size_t channel) const {
    const std::int64_t term = in[kSpecular + channel].get(row);
    if (!has_energy_) return law::rescale(term, bits_.cosine, bits_.sum);
    return law::mul(term, in[kEnergy].get(row), bits_.cosine + bits_.factor - bits_.sum);
  }

  bits_of_model bits_;
  bool has_energy_;
  std::int64_t most_;
  std::array<std::int64_t, kChannels> sums_{};
};

/// min(255, I_a k_a + sum over the lights so far of I_l k_d N.L + energy I_l k_s lobe), not rounded.
class formula_engine final : public engine {
 public:
  formula_engine(const bits_of_model& bits, bool has_energy)
      : engine(std::vector<storage>(2 * kChannels, storage::f64)), bits_(bits), has_energy_(has_energy) {}

 private:
  void compute(const columns& in, columns& out) override {
    const auto real = [&](std::size_t column, std::size_t row, int fraction) {
      return std::ldexp(in[column].real(row), -fraction);
    };
    for (std::size_t row = 0; row < in.size(); ++row) {
      const double energy = has_energy_ ? real(kEnergy, row, bits_.factor) : 1;
      for (std::size_t channel = 0; channel < kChannels; ++channel) {
        double& sum = sums_[channel];
        if (in[kFirst].get(row) != 0) sum = real(kAmbient + channel, row, bits_.coefficient);
        sum += real(kDiffuse + channel, row, bits_.coefficient) * real(kCosine, row, bits_.cosine) +
               energy * real(kSpecular + channel, row, bits_.cosine);
        out[kSum + channel].set(row, std::min(sum, 255.0));
        out[kPixel + channel].set(row, std::min(sum, 255.0));
      }
    }
  }

  bits_of_model bits_;
  bool has_energy_;
  std::array<double, kChannels> sums_{};
};

class lighting_unit final : public device {
 public:
  std::string name() const override { return "lighting"; }
  std::string title() const override {
    return "the colour of a pixel, light by light, beside a specular device";
  }
  std::string source() const override { return "thesis of Buksha"; }
  std::string figure() const override { return "(1.2), listing A"; }
  std::string good_for() const override {
    return "ambient, diffuse and specular terms in one sum, saturated: a light a clock";
  }
  std::vector<option> options() const override {
    return {{"energy",
             "a further port takes an energy factor, which multiplies the specular terms",
             {"off", "on"},
             "off"}};
  }
  void check(const selection&) const override {}
  std::string words(const selection& asked) const override {
    return asked.flag("energy") ? "energy factor" : "no energy factor";
  }

  int cycles_per_row(const selection&) const override { return 1; }

  std::unique_ptr<engine> make_bit(const selection& asked) const override {
    return visit_format(asked.format(), [&]<class Q>() -> std::unique_ptr<engine> {
      using level = typename lighting_formats<Q, false>::level;
      return std::make_unique<bit_engine>(bits_of<Q>(), asked.flag("energy"),
                                          storage_of(level::width, level::is_signed),
                                          storage_of(colour::width, colour::is_signed));
    });
  }

  word_lengths widths(const selection& asked) const override {
    return {{"sum", visit_format(asked.format(), []<class Q>() { return bits_of<Q>().sum; })}};
  }

  /// The stimulus keeps the fraction bits of its format.
  std::unique_ptr<engine> make_bit(const selection& asked, const word_lengths& bits) const override {
    bits_of_model chosen = visit_format(asked.format(), []<class Q>() { return bits_of<Q>(); });
    const known_width known[] = {{"sum", &chosen.sum, 1, chosen.coefficient + chosen.cosine}};
    take_widths(bits, known);
    return std::make_unique<bit_engine>(chosen, asked.flag("energy"), storage::i64, storage::i64);
  }

  std::unique_ptr<engine> make_golden(const selection& asked) const override {
    return std::make_unique<formula_engine>(
        visit_format(asked.format(), []<class Q>() { return bits_of<Q>(); }), asked.flag("energy"));
  }

  std::size_t enumerated() const override { return 1; }

  /// One half, where a coefficient of one unit is rounded.
  std::vector<std::int64_t> corners(const selection& asked, std::span<const std::int64_t>) const override {
    return {std::int64_t{1} << (asked.fraction() - 1)};
  }
};

}  // namespace

const device& instance() {
  static const lighting_unit device;
  return device;
}

}  // namespace blysk::lighting_device
