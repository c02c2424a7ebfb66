// SPDX-License-Identifier: Apache-2.0
// A toy device as its user meets it.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "rtl_sysc/devices/linear/linear.h"
#include "tb/specular/specular.h"
#include "tb/visit_format.h"

namespace blysk::linear_device {
namespace {

using namespace specular;

/// The blocks' laws, one write at a time.
template <class Formats>
class laws final : public engine {
 public:
  laws()
      : engine({storage_of(format_of(typename Formats::brdf{})),
                storage_of(format_of(typename Formats::out{})),
                storage_of(format_of(typename Formats::out{})),
                storage_of(format_of(typename Formats::out{}))}) {}

 private:
  void compute(const columns& in, columns& out) override {
    constexpr std::int64_t one = 1;
    for (std::size_t i = 0; i < in.size(); ++i) {
      const std::int64_t versine = Formats::add1::law(one, Formats::inv1::law(in[kCos].get(i)), one);
      const std::int64_t drop = Formats::mul2::law(in[kN].get(i), versine);
      const std::int64_t line = Formats::add2::law(one, Formats::inv2::law(drop), one);
      const std::int64_t brdf = Formats::quant2::law(line);
      out[kBrdf].set(i, brdf);
      for (std::size_t channel = 0; channel < 3; ++channel)
        out[kOutRed + channel].set(i, law::mul<std::int64_t>(brdf, in[kRed + channel].get(i), 0));
    }
  }
};

class linear final : public device_of_points {
 public:
  std::string name() const override { return "linear"; }
  std::string title() const override { return "a straight line in cos(delta)"; }
  std::string source() const override { return "a toy"; }
  std::string figure() const override { return "a line"; }
  std::string good_for() const override { return "trying the steps of the page"; }
  std::vector<option> options() const override { return {}; }
  void check(const selection&) const override {}
  std::string words(const selection&) const override { return ""; }

  std::string equation(const selection&) const override { return "BRDF = max(0, 1 - n (1 - c))"; }
  std::function<double(double, double)> formula(const selection&) const override {
    return [](double n, double c) { return std::max(0.0, 1 - n * (1 - c)); };
  }
  double root(const selection&, double n) const override { return 1 - 1 / n; }

  std::unique_ptr<engine> make_bit(const selection& asked) const override {
    return visit_format(asked.format(), []<class Q>() -> std::unique_ptr<engine> {
      return std::make_unique<laws<linear_formats<Q>>>();
    });
  }
  word_lengths widths(const selection& asked) const override { return {{"cos", asked.fraction()}}; }
  std::unique_ptr<engine> make_bit(const selection& asked, const word_lengths& bits) const override {
    const word_lengths own = widths(asked);
    for (const auto& [name, width] : bits) {
      if (own.count(name) == 0)
        throw std::invalid_argument(fmt::format("word length {} does not exist, expected cos", name));
      if (own.at(name) != width)
        throw std::invalid_argument(
            fmt::format("word length {} {} is wrong, expected {}", name, width, own.at(name)));
    }
    for (const auto& [name, width] : own) {
      if (bits.count(name) == 0)
        throw std::invalid_argument(fmt::format("word length {} is missing, expected {}", name, width));
    }
    return make_bit(asked);
  }
};

}  // namespace

const device& instance() {
  static const linear device;
  return device;
}

}  // namespace blysk::linear_device
