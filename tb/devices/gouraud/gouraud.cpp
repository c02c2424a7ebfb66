// SPDX-License-Identifier: Apache-2.0
// The Gouraud interpolator as its user meets it: formula, bit-accurate model.
#include <fmt/format.h>

#include <array>

#include "rtl_sysc/devices/gouraud/formats.h"
#include "tb/device.h"
#include "tb/devices/scan_line.h"
#include "tb/devices/shift_divider/division.h"

namespace blysk::gouraud_device {
namespace {

using scan_line::kChannels;

enum column : std::size_t { kLength = scan_line::kLength, kLeft, kRight = kLeft + kChannels };

/// The blocks' laws in the order of the clock edges.
class bit_engine final : public engine {
 public:
  bit_engine(int steps, storage result)
      : engine({result, result, result}), steps_(steps), words_(shift_divider_device::reciprocals(steps)) {}

 private:
  void compute(const columns& in, columns& out) override {
    scan_line::for_channels(in, out,
                            [&](std::size_t row, std::size_t channel, std::size_t first, std::size_t pixels) {
                              draw(in, row, channel, out, first, pixels);
                            });
  }

  void draw(const columns& in, std::size_t row, std::size_t channel, columns& out, std::size_t first,
            std::size_t pixels) const {
    const std::int64_t left = in[kLeft + channel].get(row);
    const std::int64_t right = in[kRight + channel].get(row);
    const auto difference = law::add<std::int64_t>(right, 0, law::ones_complement(left, 0), 0, 1);
    const std::int64_t digits = words_[static_cast<std::size_t>(in[kLength].get(row))];
    const std::int64_t increment = shift_divider_device::divide(difference, digits, steps_);
    std::int64_t intensity = law::move_up(left, steps_);
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
    scan_line::for_channels(
        in, out, [&](std::size_t row, std::size_t channel, std::size_t first, std::size_t pixels) {
          const auto length = static_cast<double>(in[kLength].get(row));
          const double left = in[kLeft + channel].real(row);
          const double right = in[kRight + channel].real(row);
          for (std::size_t x = 0; x < pixels; ++x)
            out[channel].set(first + x, left + static_cast<double>(x) * (right - left) / length);
        });
  }
};

class gouraud_interpolator final : public device {
 public:
  std::string name() const override { return "gouraud"; }
  std::string title() const override { return "a scan line between two colours, its increments by shifts"; }
  std::string source() const override { return "thesis of Buksha"; }
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
  std::int64_t pixels(const columns& in, std::size_t row) const override {
    return scan_line::pixels_of(in, row);
  }

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
