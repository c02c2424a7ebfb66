// SPDX-License-Identifier: Apache-2.0
#include "tb/specular/parabola_engines.h"

#include <fmt/format.h>

#include <stdexcept>

namespace blysk::specular {

free_shape shape_of(const word_lengths& bits, bool is_clamped, rounding how) {
  for (const auto& [name, width] : bits) {
    if (name != "cos" && name != "coefficient" && name != "square")
      throw std::invalid_argument(
          fmt::format("word length {} does not exist, expected cos, coefficient and square", name));
  }
  const auto at = [&](const char* name) {
    const auto found = bits.find(name);
    if (found == bits.end()) throw std::invalid_argument(fmt::format("word length {} is missing", name));
    return found->second;
  };
  // Of the nets of parabola_formats the square, UQ2.2F, and the parabola, SQ8.(K + D), are the widest.
  constexpr int kWidest = 64;
  const int parabola_width = 1 + 8 + at("coefficient") + at("square");
  const free_shape shape{
      at("cos"), at("coefficient"), at("square"), is_clamped, law::has_headroom(parabola_width), how};
  const bool fits = shape.cos_bits >= 1 && shape.coefficient_bits >= 1 && shape.diff_bits >= shape.cos_bits &&
                    shape.diff_bits <= 2 * shape.cos_bits && 2 + 2 * shape.cos_bits < kWidest &&
                    parabola_width <= kWidest;
  if (!fits) {
    throw std::invalid_argument(fmt::format(
        "word lengths cos {}, coefficient {}, square {} do not fit, expected 1 <= cos <= 30, cos <= "
        "square <= 2 cos, 1 <= coefficient, coefficient + square <= 55",
        shape.cos_bits, shape.coefficient_bits, shape.diff_bits));
  }
  return shape;
}

word_lengths widths_of(int cos_bits, int coefficient_bits) {
  return {{"cos", cos_bits}, {"coefficient", coefficient_bits}, {"square", square_bits(cos_bits)}};
}

}  // namespace blysk::specular
