// SPDX-License-Identifier: Apache-2.0
#include "tb/specular/specular.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace blysk::specular {
namespace {

/// A formula at the codes of n and cos; the colours are its products.
class formula_engine final : public engine {
 public:
  formula_engine(std::function<double(double, double)> formula, int fraction)
      : engine({storage::f64, storage::f64, storage::f64, storage::f64}),
        formula_(std::move(formula)),
        fraction_(fraction) {}

 private:
  void compute(const columns& in, columns& out) override {
    double* const brdf = out[kBrdf].data<double>();
    const auto* const n = in[kN].data<std::uint16_t>();
    in[kCos].visit([&](const auto& codes) {
      for (std::size_t i = 0; i < in.size(); ++i)
        brdf[i] = formula_(n[i], std::ldexp(static_cast<double>(codes[i]), -fraction_));
    });
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const auto* const colour = in[kRed + channel].data<std::uint8_t>();
      double* const shaded = out[kOutRed + channel].data<double>();
      for (std::size_t i = 0; i < in.size(); ++i) shaded[i] = brdf[i] * colour[i];
    }
  }

  std::function<double(double, double)> formula_;
  int fraction_;
};

}  // namespace

std::vector<std::int64_t> device_of_points::corners(const selection& asked,
                                                    std::span<const std::int64_t> before) const {
  return {std::lround(std::ldexp(root(asked, static_cast<double>(before.front())), asked.fraction()))};
}

std::unique_ptr<engine> device_of_points::make_golden(const selection& asked) const {
  return std::make_unique<formula_engine>(formula(asked), asked.fraction());
}

void check_only_cosine(const selection& asked, const word_lengths& bits) {
  for (const auto& [name, width] : bits) {
    if (name != "cos")
      throw std::invalid_argument(fmt::format("word length {} does not exist, expected cos", name));
    if (width != asked.fraction())
      throw std::invalid_argument(fmt::format("word length cos {} is wrong, expected {}, that of the format",
                                              width, asked.fraction()));
  }
  if (bits.empty())
    throw std::invalid_argument(
        fmt::format("word length cos is missing, expected one like {}", asked.fraction()));
}

}  // namespace blysk::specular
