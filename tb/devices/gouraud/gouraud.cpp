// SPDX-License-Identifier: Apache-2.0
// The Gouraud interpolator as its user meets it: formula, bit-accurate model.
#include <fmt/format.h>

#include <array>

#include "rtl_sysc/devices/gouraud/formats.h"
#include "tb/device.h"
#include "tb/devices/shift_divider/division.h"

namespace blysk::gouraud_device {
namespace {

enum column : std::size_t { kLength, kLeft, kRight = kLeft + 3 };
constexpr std::size_t kChannels = 3;

std::int64_t pixels_of(const columns& in, std::size_t row) {
  return in[kLength].get(row) + 1;
}

std::size_t pixels_of_all(const columns& in) {
  std::int64_t sum = 0;
  for (std::size_t row = 0; row < in.size(); ++row) sum += pixels_of(in, row);
  return static_cast<std::size_t>(sum);
}

/// The blocks' laws in the order of the clock edges.
class bit_engine final : public engine {
 public:
  bit_engine(int steps, storage result)
      : engine({result, result, result}), steps_(steps), words_(shift_divider_device::reciprocals(steps)) {}

 private:
  void compute(const columns& in, columns& out) override {
    out.resize(pixels_of_all(in));
    std::size_t first = 0;
    for (std::size_t row = 0; row < in.size(); ++row) {
      for (std::size_t channel = 0; channel < kChannels; ++channel) draw(in, row, channel, out, first);
      first += static_cast<std::size_t>(pixels_of(in, row));
    }
  }

  void draw(const columns& in, std::size_t row, std::size_t channel, columns& out, std::size_t first) const {
    const std::int64_t left = in[kLeft + channel].get(row);
    const std::int64_t right = in[kRight + channel].get(row);
    const auto difference = law::add<std::int64_t>(right, 0, law::ones_complement(left, 0), 0, 1);
    const std::int64_t digits = words_[static_cast<std::size_t>(in[kLength].get(row))];
    const std::int64_t increment = shift_divider_device::divide(difference, digits, steps_);
    std::int64_t intensity = law::move_up(left, steps_);
    const auto pixels = static_cast<std::size_t>(pixels_of(in, row));
    out[channel].visit([&](auto& colours) {
      using element = typename std::remove_reference_t<decltype(colours)>::value_type;
      for (std::size_t x = 0; x < pixels; ++x) {
        const auto level =
            law::clamp<std::int64_t>(law::round_off(intensity, steps_), colour::min, colour::max);
        colours[first + x] = static_cast<element>(level);
        intensity = law::add<std::int64_t>(intensity, 0, increment, 0, 0);
      }
    });
  }

  int steps_;
  std::vector<std::int64_t> words_;
};

/// left + x (right - left) / length.
class formula_engine final : public engine {
 public:
  formula_engine() : engine({storage::f64, storage::f64, storage::f64}) {}

 private:
  void compute(const columns& in, columns& out) override {
    out.resize(pixels_of_all(in));
    std::size_t pixel = 0;
    for (std::size_t row = 0; row < in.size(); ++row) {
      const auto length = static_cast<double>(in[kLength].get(row));
      for (std::int64_t x = 0; x < pixels_of(in, row); ++x, ++pixel) {
        for (std::size_t channel = 0; channel < kChannels; ++channel) {
          const double left = in[kLeft + channel].real(row);
          out[channel].set(pixel,
                           left + static_cast<double>(x) * (in[kRight + channel].real(row) - left) / length);
        }
      }
    }
  }
};

class gouraud_interpolator final : public device {
 public:
  std::string name() const override { return "gouraud"; }
  std::string title() const override { return "a scan line between two colours, its increments by shifts"; }
  std::string source() const override { return "thesis"; }
  std::string figure() const override { return "2.4, fig. 2.13"; }
  std::string good_for() const override {
    return "a pixel a clock in three channels; the error grows along the line";
  }
  std::vector<option> options() const override { return {}; }
  void check(const selection&) const override {}
  std::string words(const selection& asked) const override {
    return fmt::format("{} shifts", asked.fraction());
  }

  bool draws_lines() const override { return true; }
  std::int64_t pixels(const columns& in, std::size_t row) const override { return pixels_of(in, row); }

  std::unique_ptr<engine> make_bit(const selection& asked) const override {
    return std::make_unique<bit_engine>(asked.fraction(), storage_of(colour::width, colour::is_signed));
  }

  std::int64_t rom_bits(const selection& asked) const override {
    return (run_length::max + 1) * (std::int64_t{asked.fraction()} + 1);
  }

  word_lengths widths(const selection& asked) const override { return {{"steps", asked.fraction()}}; }

  std::unique_ptr<engine> make_bit(const selection&, const word_lengths& bits) const override {
    return std::make_unique<bit_engine>(shift_divider_device::steps_of(bits), storage::i64);
  }

  std::unique_ptr<engine> make_golden(const selection&) const override {
    return std::make_unique<formula_engine>();
  }

  std::size_t enumerated() const override { return 1; }

  std::vector<std::int64_t> corners(const selection&, std::span<const std::int64_t>) const override {
    return shift_divider_device::powers_of_two();
  }
};

}  // namespace

const device& instance() {
  static const gouraud_interpolator device;
  return device;
}

}  // namespace blysk::gouraud_device
