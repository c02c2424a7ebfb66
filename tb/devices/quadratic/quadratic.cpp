// SPDX-License-Identifier: Apache-2.0
// The device of UA 60553 as its user meets it: options, formula, bit-accurate model.
#include <fmt/format.h>

#include <string>

#include "tb/devices/quadratic/kernel.h"
#include "tb/devices/quadratic/wires.h"
#include "tb/specular/parabola_formula.h"
#include "tb/visit_format.h"

namespace blysk::quadratic_device {

wired_constants wires(const selection& asked, int bits) {
  wired_constants wired =
      asked.value("coefficient") == "published" ? published_line(bits) : derived_line(bits);
  const std::string& constant = asked.value("constant");
  if (constant.empty()) return wired;
  if (constant.front() != '1' || constant.find_first_not_of("01") != std::string::npos ||
      constant.size() > static_cast<std::size_t>(bits)) {
    throw std::invalid_argument(fmt::format(
        "constant {} cannot be wired at node 31, expected 1 to {} bits of 0 and 1, the first of them 1",
        constant, bits));
  }
  wired.slope = std::stoll(constant, nullptr, 2) << (bits - static_cast<int>(constant.size()));
  return wired;
}

wired_constants wires(const selection& asked) {
  return wires(asked, slope_bits(asked.fraction()));
}

namespace {

class quadratic final : public specular::parabola, public specular::rounded_in_any_way {
 public:
  std::string name() const override { return "quadratic"; }
  std::string title() const override { return "a quadratic in cos(delta), its coefficient a line in n"; }
  std::string source() const override { return "patent UA 60553"; }
  std::string figure() const override { return "fig. 1"; }
  std::string good_for() const override {
    return "no memory; follows the core of the highlight, cuts its skirt off";
  }

  std::vector<option> options() const override {
    return {coefficient_option({"derived", "published"}, {"exact"}),
            {.name = "constant",
             .help = "bits wired at node 31 after the point, such as 11001001",
             .is_wired = true},
            as_published_option()};
  }

  void check(const selection& asked) const override {
    if (asked.is_for() == purpose::hardware) wires(asked);
  }

  std::string words(const selection& asked) const override {
    const std::string& constant = asked.value("constant");
    return fmt::format("coefficient {}{}{}", asked.value("coefficient"),
                       constant.empty() ? "" : fmt::format(", constant 0.{}b", constant), lobe_words(asked));
  }

  std::int64_t wired_coefficient(const selection& asked, int n) const override {
    const wired_constants wired = wires(asked);
    return wired.slope * n + wired.offset * (std::int64_t{1} << (slope_bits(asked.fraction()) - 1));
  }

  std::unique_ptr<engine> make_bit(const selection& asked) const override {
    const wired_constants wired = wires(asked);
    const auto make = [wired]<class Formats>() {
      return specular::make_kernel_engine<Formats>(
          [wired](const specular::columns_of<Formats>& io) { compute<Formats>(wired, io); });
    };
    return visit_format(asked.format(), [&]<class Q>() {
      return asked.flag("as-published")
                 ? make.template operator()<quadratic_formats<Q, negative_lobe::as_published>>()
                 : make.template operator()<quadratic_formats<Q, negative_lobe::clamped>>();
    });
  }

  word_lengths widths(const selection& asked) const override {
    return specular::widths_of(asked.fraction(), slope_bits(asked.fraction()));
  }

  std::unique_ptr<engine> make_bit(const selection& asked, const word_lengths& bits) const override {
    return make_rounded(asked, bits, specular::rounding::nearest);
  }

  std::unique_ptr<engine> make_rounded(const selection& asked, const word_lengths& bits,
                                       specular::rounding how) const override {
    const specular::free_shape shape = specular::shape_of(bits, !asked.flag("as-published"), how);
    return specular::make_free_engine([shape, wired = wires(asked, shape.coefficient_bits)](
                                          const specular::free_columns& io) { compute(shape, wired, io); });
  }
};

}  // namespace

const device& instance() {
  static const quadratic device;
  return device;
}

}  // namespace blysk::quadratic_device
