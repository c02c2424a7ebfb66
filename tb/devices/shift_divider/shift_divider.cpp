// SPDX-License-Identifier: Apache-2.0
// The divider by shifts as its user meets it: formula, bit-accurate model.
#include <fmt/format.h>

#include "rtl_sysc/devices/shift_divider/formats.h"
#include "tb/device.h"
#include "tb/devices/shift_divider/division.h"
#include "tb/golden/shift_division.h"
#include "tb/visit_format.h"

namespace blysk::shift_divider_device {
namespace {

enum column : std::size_t { kDifference, kLength };

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
  std::string source() const override { return "thesis of Buksha"; }
  std::string figure() const override { return "fig. 2.13"; }
  std::string good_for() const override {
    return "increments of a scan line without a divider; the error grows with the difference";
  }
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
    return std::make_unique<bit_engine>(steps_of(bits), storage::i64);
  }

  std::unique_ptr<engine> make_golden(const selection& asked) const override {
    return std::make_unique<formula_engine>(asked.fraction());
  }

  std::size_t enumerated() const override { return 2; }

  /// Powers of two, which have one digit.
  std::vector<std::int64_t> corners(const selection&, std::span<const std::int64_t>) const override {
    return powers_of_two();
  }
};

}  // namespace

const device& instance() {
  static const shift_divider_of device;
  return device;
}

}  // namespace blysk::shift_divider_device
