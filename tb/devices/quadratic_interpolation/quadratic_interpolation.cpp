// SPDX-License-Identifier: Apache-2.0
// The interpolator by forward differences as its user meets it: formula, bit-accurate model.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "rtl_sysc/devices/quadratic_interpolation/formats.h"
#include "tb/device.h"
#include "tb/devices/scan_line.h"

namespace blysk::quadratic_interpolation_device {
namespace {

/// Columns of a channel after the length: value, first and second difference.
constexpr std::size_t value_column(std::size_t channel) {
  return 1 + 3 * channel;
}

/// The blocks' laws in the order of the clock edges.
class bit_engine final : public engine {
 public:
  bit_engine(int frac, storage result) : engine({result, result, result}), frac_(frac) {}

 private:
  void compute(const columns& in, columns& out) override {
    scan_line::for_channels(
        in, out, [&](std::size_t row, std::size_t channel, std::size_t first, std::size_t pixels) {
          const std::size_t column = value_column(channel);
          std::int64_t value = in[column].get(row);
          std::int64_t difference = in[column + 1].get(row);
          const std::int64_t second = in[column + 2].get(row);
          out[channel].visit([&](auto& colours) {
            using element = typename std::remove_reference_t<decltype(colours)>::value_type;
            for (std::size_t x = 0; x < pixels; ++x) {
              colours[first + x] = static_cast<element>(
                  law::clamp<std::int64_t>(law::round_off(value, frac_), colour::min, colour::max));
              value = law::add<std::int64_t>(value, 0, difference, 0, 0);
              difference = law::add<std::int64_t>(difference, 0, second, 0, 0);
            }
          });
        });
  }

  int frac_;
};

/// value + x first + x (x - 1)/2 second, limited to 0..255.
class formula_engine final : public engine {
 public:
  explicit formula_engine(int frac) : engine({storage::f64, storage::f64, storage::f64}), frac_(frac) {}

 private:
  void compute(const columns& in, columns& out) override {
    scan_line::for_channels(
        in, out, [&](std::size_t row, std::size_t channel, std::size_t first, std::size_t pixels) {
          const auto coefficient = [&](std::size_t which) {
            return std::ldexp(in[value_column(channel) + which].real(row), -frac_);
          };
          const double value = coefficient(0);
          const double difference = coefficient(1);
          const double second = coefficient(2);
          for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
            const auto x = static_cast<double>(pixel);
            out[channel].set(first + pixel,
                             std::clamp(value + x * difference + x * (x - 1) / 2 * second, 0.0, 255.0));
          }
        });
  }

  int frac_;
};

class interpolator final : public device {
 public:
  std::string name() const override { return "quadratic-interpolation"; }
  std::string title() const override {
    return "a scan line of a quadratic polynomial, by forward differences";
  }
  std::string source() const override { return "thesis of Buksha"; }
  std::string figure() const override { return "listing A"; }
  std::string good_for() const override {
    return "a highlight inside a triangle, a pixel a clock; the error grows with the square of the length";
  }
  std::vector<option> options() const override { return {}; }
  void check(const selection&) const override {}
  std::string words(const selection& asked) const override {
    return fmt::format("{} fraction bits", asked.fraction());
  }

  bool draws_lines() const override { return true; }
  std::int64_t pixels(const columns& in, std::size_t row) const override {
    return scan_line::pixels_of(in, row);
  }

  std::unique_ptr<engine> make_bit(const selection& asked) const override {
    return std::make_unique<bit_engine>(asked.fraction(), storage_of(colour::width, colour::is_signed));
  }

  word_lengths widths(const selection& asked) const override { return {{"fraction", asked.fraction()}}; }

  /// The stimulus keeps the fraction bits of its format; the model takes the codes as having `fraction`.
  std::unique_ptr<engine> make_bit(const selection&, const word_lengths& bits) const override {
    constexpr int kMost = 40;  // 22 integer bits beside them in 64
    for (const auto& [name, width] : bits) {
      if (name != "fraction")
        throw std::invalid_argument(fmt::format("word length {} does not exist, expected fraction", name));
      if (width < 1 || width > kMost) {
        throw std::invalid_argument(
            fmt::format("word length fraction {} is outside its range, expected 1..{}", width, kMost));
      }
    }
    if (bits.empty()) throw std::invalid_argument("word length fraction is missing");
    return std::make_unique<bit_engine>(bits.at("fraction"), storage::i64);
  }

  std::unique_ptr<engine> make_golden(const selection& asked) const override {
    return std::make_unique<formula_engine>(asked.fraction());
  }

  std::size_t enumerated() const override { return 1; }

  std::vector<std::int64_t> corners(const selection&, std::span<const std::int64_t>) const override {
    return {};
  }
};

}  // namespace

const device& instance() {
  static const interpolator device;
  return device;
}

}  // namespace blysk::quadratic_interpolation_device
