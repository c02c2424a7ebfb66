// SPDX-License-Identifier: Apache-2.0
// The restoring divider as its user meets it: formula, bit-accurate model.
#include <fmt/format.h>

#include <stdexcept>

#include "rtl_sysc/devices/restoring_divider/formats.h"
#include "tb/device.h"
#include "tb/visit_format.h"

namespace blysk::restoring_divider_device {
namespace {

enum column : std::size_t { kDifference, kLength };

constexpr int kPlaces = restoring_divider_formats<q8>::places;

/// difference / length with `bits` fraction bits, raw: the blocks' laws in the order of the nets.
std::int64_t divided(std::int64_t difference, std::int64_t length, int bits) {
  const std::int64_t divisor = law::move_up(length, kPlaces);
  const std::int64_t quotient =
      law::divide(law::magnitude(difference), divisor, run_length::width + kPlaces, kPlaces + bits);
  return law::with_sign(law::is_negative(difference), quotient);
}

class bit_engine final : public engine {
 public:
  bit_engine(int bits, storage result) : engine({result}), bits_(bits) {}

 private:
  void compute(const columns& in, columns& out) override {
    out[0].visit([&](auto& increments) {
      using element = typename std::remove_reference_t<decltype(increments)>::value_type;
      for (std::size_t i = 0; i < in.size(); ++i)
        increments[i] = static_cast<element>(divided(in[kDifference].get(i), in[kLength].get(i), bits_));
    });
  }

  int bits_;
};

class formula_engine final : public engine {
 public:
  formula_engine() : engine({storage::f64}) {}

 private:
  void compute(const columns& in, columns& out) override {
    double* const increments = out[0].data<double>();
    for (std::size_t i = 0; i < in.size(); ++i) increments[i] = in[kDifference].real(i) / in[kLength].real(i);
  }
};

class restoring_divider_of final : public device {
 public:
  std::string name() const override { return "restoring-divider"; }
  std::string title() const override {
    return "division of a difference by a run length, a digit each clock cycle";
  }
  std::string source() const override { return "own design"; }
  std::string figure() const override { return "in the place of the thesis's fig. 2.13"; }
  std::string good_for() const override {
    return "increments of a scan line to the last place; what shift-divider is compared with";
  }
  std::vector<option> options() const override { return {}; }
  void check(const selection&) const override {}
  std::string words(const selection& asked) const override {
    return fmt::format("{} digits", kPlaces + asked.fraction());
  }

  std::unique_ptr<engine> make_bit(const selection& asked) const override {
    const storage result = visit_format(asked.format(), []<class Q>() {
      using increment = typename restoring_divider_formats<Q>::increment;
      return storage_of(increment::width, increment::is_signed);
    });
    return std::make_unique<bit_engine>(asked.fraction(), result);
  }

  word_lengths widths(const selection& asked) const override { return {{"increment", asked.fraction()}}; }

  std::unique_ptr<engine> make_bit(const selection&, const word_lengths& bits) const override {
    constexpr int kMost = 48;
    for (const auto& [name, width] : bits) {
      if (name != "increment")
        throw std::invalid_argument(fmt::format("word length {} does not exist, expected increment", name));
      if (width < 1 || width > kMost)
        throw std::invalid_argument(
            fmt::format("word length increment {} is outside its range, expected 1..{}", width, kMost));
    }
    if (bits.empty()) throw std::invalid_argument("word length increment is missing");
    return std::make_unique<bit_engine>(bits.at("increment"), storage::i64);
  }

  std::unique_ptr<engine> make_golden(const selection&) const override {
    return std::make_unique<formula_engine>();
  }

  std::size_t enumerated() const override { return 2; }

  /// Powers of two, whose quotients are exact.
  std::vector<std::int64_t> corners(const selection&, std::span<const std::int64_t>) const override {
    std::vector<std::int64_t> codes;
    for (std::int64_t k = 2; k <= run_length::max; k *= 2) codes.push_back(k);
    return codes;
  }
};

}  // namespace

const device& instance() {
  static const restoring_divider_of device;
  return device;
}

}  // namespace blysk::restoring_divider_device
