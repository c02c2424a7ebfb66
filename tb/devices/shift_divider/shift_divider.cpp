// SPDX-License-Identifier: Apache-2.0
// The divider by shifts as its user meets it: formula, bit-accurate model.
#include <fmt/format.h>

#include <bit>

#include "rtl_sysc/devices/shift_divider/formats.h"
#include "tb/device.h"
#include "tb/golden/shift_division.h"
#include "tb/visit_format.h"

namespace blysk::shift_divider_device {
namespace {

enum column : std::size_t { kDifference, kLength };

/// The words of the ROM for any number of steps.
std::vector<std::int64_t> reciprocals(int steps) {
  std::vector<std::int64_t> words(std::size_t{run_length::max} + 1, 0);
  for (std::size_t k = 1; k < words.size(); ++k) words[k] = rounded_ratio(1, k, steps);
  return words;
}

/// The blocks' laws in the order of the clock edges.
/// \return  the increment, raw, with `steps` fraction bits
std::int64_t divide(std::int64_t difference, std::int64_t digits, int steps) {
  const int width = steps + 1;
  std::int64_t sum = law::first_bit(digits, width) != 0 ? law::move_up(difference, steps) : 0;
  std::int64_t shifted = law::move_up(difference, steps - 1);
  for (int step = 1; step <= steps; ++step) {
    digits = law::other_bits(digits, width);
    if (law::first_bit(digits, width) != 0) sum = law::add<std::int64_t>(sum, 0, shifted, 0, 0);
    shifted = law::halve(shifted);
  }
  return sum;
}

class bit_engine final : public engine {
 public:
  bit_engine(int steps, storage result) : engine({result}), steps_(steps), words_(reciprocals(steps)) {}

 private:
  void compute(const columns& in, columns& out) override {
    out[0].visit([&](auto& increments) {
      using element = typename std::remove_reference_t<decltype(increments)>::value_type;
      for (std::size_t i = 0; i < in.size(); ++i) {
        const std::int64_t digits = words_[static_cast<std::size_t>(in[kLength].get(i))];
        increments[i] = static_cast<element>(divide(in[kDifference].get(i), digits, steps_));
      }
    });
  }

  int steps_;
  std::vector<std::int64_t> words_;
};

class formula_engine final : public engine {
 public:
  explicit formula_engine(int steps) : engine({storage::f64}), steps_(steps) {}

 private:
  void compute(const columns& in, columns& out) override {
    double* const increments = out[0].data<double>();
    for (std::size_t i = 0; i < in.size(); ++i) {
      increments[i] = golden::shifted_quotient(in[kDifference].real(i),
                                               static_cast<std::uint32_t>(in[kLength].get(i)), steps_);
    }
  }

  int steps_;
};

class shift_divider_of final : public device {
 public:
  std::string name() const override { return "shift-divider"; }
  std::string title() const override {
    return "division of a difference by a run length, by shifts and additions";
  }
  std::string source() const override { return "thesis, fig. 2.13"; }
  std::vector<option> options() const override { return {}; }
  void check(const selection&) const override {}
  std::string words(const selection& asked) const override {
    return fmt::format("{} shifts", asked.fraction());
  }

  std::unique_ptr<engine> make_bit(const selection& asked) const override {
    const storage result = visit_format(asked.format(), []<class Q>() {
      using increment = typename shift_divider_formats<Q>::increment;
      return storage_of(increment::width, increment::is_signed);
    });
    return std::make_unique<bit_engine>(asked.fraction(), result);
  }

  std::int64_t rom_bits(const selection& asked) const override {
    return (run_length::max + 1) * (std::int64_t{asked.fraction()} + 1);
  }

  word_lengths widths(const selection& asked) const override { return {{"steps", asked.fraction()}}; }

  std::unique_ptr<engine> make_bit(const selection&, const word_lengths& bits) const override {
    constexpr int kMostSteps = 48;
    for (const auto& [name, width] : bits) {
      if (name != "steps")
        throw std::invalid_argument(fmt::format("word length {} does not exist, expected steps", name));
      if (width < 1 || width > kMostSteps)
        throw std::invalid_argument(
            fmt::format("word length steps {} is outside its range, expected 1..{}", width, kMostSteps));
    }
    if (bits.empty()) throw std::invalid_argument("word length steps is missing");
    return std::make_unique<bit_engine>(bits.at("steps"), storage::i64);
  }

  std::unique_ptr<engine> make_golden(const selection& asked) const override {
    return std::make_unique<formula_engine>(asked.fraction());
  }

  std::size_t enumerated() const override { return 2; }

  /// Powers of two, which have one digit.
  std::vector<std::int64_t> corners(const selection&, std::span<const std::int64_t>) const override {
    std::vector<std::int64_t> codes;
    for (std::int64_t k = 2; k <= run_length::max; k *= 2) codes.push_back(k);
    return codes;
  }
};

}  // namespace

const device& instance() {
  static const shift_divider_of device;
  return device;
}

}  // namespace blysk::shift_divider_device
