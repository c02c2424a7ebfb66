// SPDX-License-Identifier: Apache-2.0
// The prototype UA 22802 as its user meets it: options, formula, bit-accurate model.
#include <fmt/format.h>

#include <string>

#include "tb/devices/quadratic_rom/kernel.h"
#include "tb/devices/quadratic_rom/words.h"
#include "tb/specular/parabola_formula.h"
#include "tb/visit_format.h"

namespace blysk::quadratic_rom_device {
namespace {

constexpr int kAddresses = 1000;  // exponents

/// The contents that the options ask for, with `bits` fraction bits.
memory words_of(const selection& asked, int bits) {
  memory words{};
  const int which = contents(asked);
  for (std::uint64_t n = 1; n <= kAddresses; ++n) {
    const std::int64_t word = which == 0   ? exact_word(n, bits)
                              : which == 1 ? derived_word(n, bits)
                                           : published_word(n, bits);
    words[n] = static_cast<std::int32_t>(word);
  }
  return words;
}

/// Fraction bits of the words.
int word_bits(const selection& asked) {
  return min_of(asked.fraction(), 20);
}

class quadratic_rom final : public specular::parabola, public specular::rounded_in_any_way {
 public:
  std::string name() const override { return "quadratic-rom"; }
  std::string title() const override {
    return "a quadratic in cos(delta), its coefficient read from a memory";
  }
  std::string source() const override { return "patent UA 22802"; }
  std::string figure() const override { return "UA 60553 fig. 1 with a memory"; }
  std::string good_for() const override { return "the quadratic with the exact coefficient at small n"; }

  std::vector<option> options() const override {
    return {coefficient_option({"exact", "derived", "published"}, {}),
            {.name = "rom",
             .help = "the memory as logic, or clocked as a block RAM, which takes a cycle more",
             .values = {"logic", "clocked"},
             .preset = "logic",
             .is_wired = true},
            as_published_option()};
  }

  void check(const selection&) const override {}

  std::string words(const selection& asked) const override {
    return fmt::format("memory of {} words of {} bits{}, coefficient {}{}", kAddresses, 10 + word_bits(asked),
                       asked.value("rom") == "clocked" ? ", clocked" : "", asked.value("coefficient"),
                       lobe_words(asked));
  }

  std::int64_t rom_bits(const selection& asked) const override {
    return std::int64_t{kAddresses} * (10 + word_bits(asked));
  }

  std::int64_t wired_coefficient(const selection& asked, int n) const override {
    return words_of(asked, word_bits(asked)).at(static_cast<std::size_t>(n));
  }

  std::unique_ptr<engine> make_bit(const selection& asked) const override {
    const auto make = [memory = words_of(asked, word_bits(asked))]<class Formats>() {
      return specular::make_kernel_engine<Formats>(
          [memory](const specular::columns_of<Formats>& io) { compute<Formats>(memory, io); });
    };
    return visit_format(asked.format(), [&]<class Q>() {
      return asked.flag("as-published")
                 ? make.template operator()<quadratic_rom_formats<Q, negative_lobe::as_published>>()
                 : make.template operator()<quadratic_rom_formats<Q, negative_lobe::clamped>>();
    });
  }

  word_lengths widths(const selection& asked) const override {
    return specular::widths_of(asked.fraction(), word_bits(asked));
  }

  std::unique_ptr<engine> make_bit(const selection& asked, const word_lengths& bits) const override {
    return make_rounded(asked, bits, specular::rounding::nearest);
  }

  std::unique_ptr<engine> make_rounded(const selection& asked, const word_lengths& bits,
                                       specular::rounding how) const override {
    const specular::free_shape shape = specular::shape_of(bits, !asked.flag("as-published"), how);
    if (shape.coefficient_bits > 20)
      throw std::invalid_argument(
          fmt::format("word length coefficient is {}, expected at most 20", shape.coefficient_bits));
    return specular::make_free_engine([shape, memory = words_of(asked, shape.coefficient_bits)](
                                          const specular::free_columns& io) { compute(shape, memory, io); });
  }
};

}  // namespace

const device& instance() {
  static const quadratic_rom device;
  return device;
}

}  // namespace blysk::quadratic_rom_device
